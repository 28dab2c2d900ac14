<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Show the whole drawing</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>全体図</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>after {0}</source>
        <translation>{0} の後</translation>
    </message>
    <message>
        <source>begins the same state anew</source>
        <translation>同じ状態を最初からやり直します</translation>
    </message>
    <message>
        <source>leads back</source>
        <translation>前に戻ります</translation>
    </message>
    <message>
        <source>Drag to where a new event leads</source>
        <translation>新しいイベントの行き先へドラッグしてください</translation>
    </message>
    <message>
        <source>leads to state {0}, which does not exist</source>
        <translation>行き先の状態 {0} がありません</translation>
    </message>
    <message>
        <source>stays in the state</source>
        <translation>この状態にとどまります</translation>
    </message>
    <message>
        <source>start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>end</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>part</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>has an error</source>
        <translation>エラーがあります</translation>
    </message>
    <message>
        <source>has a warning</source>
        <translation>警告があります</translation>
    </message>
    <message>
        <source>if {0}</source>
        <translation>{0} のとき</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>すぐに</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>is part of every state</source>
        <translation>すべての状態に共通</translation>
    </message>
    <message>
        <source>extends {0}</source>
        <translation>{0} を引き継ぐ</translation>
    </message>
    <message>
        <source>always</source>
        <translation>常に</translation>
    </message>
    <message>
        <source>stays {0} at least</source>
        <translation>少なくとも {0} 続く</translation>
    </message>
    <message>
        <source>ends after {0}</source>
        <translation>{0} 後に終わる</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>観測されていない</translation>
    </message>
    <message>
        <source>any value</source>
        <translation>任意の値</translation>
    </message>
    <message>
        <source>not declared</source>
        <translation>宣言されていない</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Also asked for by</source>
        <translation>ほかに求めているもの</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>実行権</translation>
    </message>
    <message>
        <source>A part of the robot that one module at a time moves.</source>
        <translation>一度に一つのモジュールが動かす、ロボットの部分。</translation>
    </message>
    <message>
        <source>The module that moves it now.</source>
        <translation>今動かしているモジュール。</translation>
    </message>
    <message>
        <source>How long it has held it.</source>
        <translation>使っている時間。</translation>
    </message>
    <message>
        <source>Modules that want it too, and do not get it.</source>
        <translation>ほかに要求しているが使えないモジュール。</translation>
    </message>
    <message>
        <source>What it was told to do last.</source>
        <translation>最後に受けた指令。</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>What the value is about, such as user.name.</source>
        <translation>値の名前。user.name など。</translation>
    </message>
    <message>
        <source>The value as the robot knows it now; private ones are hidden.</source>
        <translation>ロボットが今知っている値。個人情報は隠します。</translation>
    </message>
    <message>
        <source>Which program or application set it last.</source>
        <translation>最後に書き込んだプログラムかアプリケーション。</translation>
    </message>
    <message>
        <source>How long ago it was set.</source>
        <translation>書き込まれてからの時間。</translation>
    </message>
    <message>
        <source>operator {0}</source>
        <translation>操作者 {0}</translation>
    </message>
    <message>
        <source>Set by</source>
        <translation>書き込み元</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>The robot pauses</source>
        <translation>ロボットが止まるところ</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>ブレークポイント</translation>
    </message>
    <message>
        <source>The breakpoint&apos;s number; green where something waits at it</source>
        <translation>ブレークポイントの番号。そこで待っているものがあれば緑</translation>
    </message>
    <message>
        <source>A click goes there, Delete takes the breakpoint away</source>
        <translation>クリックでその場所へ、Delete で取り除きます</translation>
    </message>
    <message>
        <source>Which application pauses</source>
        <translation>止まるアプリケーション</translation>
    </message>
    <message>
        <source>The operator who set it</source>
        <translation>設定した操作者</translation>
    </message>
    <message>
        <source>Pauses only while</source>
        <translation>次の間だけ止まる</translation>
    </message>
    <message>
        <source>Set {0} from before on this robot, too</source>
        <translation>前に付けた {0} をこのロボットにも付ける</translation>
    </message>
    <message>
        <source>not on this robot</source>
        <translation>このロボットにはありません</translation>
    </message>
    <message>
        <source>in situation {0}</source>
        <translation>状況 {0} のとき</translation>
    </message>
    <message>
        <source>before it leaves {0}</source>
        <translation>{0} を離れる前</translation>
    </message>
    <message>
        <source>before it comes to {0}</source>
        <translation>{0} に入る前</translation>
    </message>
    <message>
        <source>between {0} and {1}</source>
        <translation>{0} と {1} の間</translation>
    </message>
    <message>
        <source>{0}, while {1}</source>
        <translation>{0}（{1} の間）</translation>
    </message>
    <message>
        <source>Only an operator may change it: your key lets you look only.</source>
        <translation>変えられるのは操作者だけです。この鍵では見ることだけができます。</translation>
    </message>
    <message>
        <source>Always. Add a test, as in a guard.</source>
        <translation>いつも。条件と同じように判定を足せます。</translation>
    </message>
    <message>
        <source>Select a breakpoint of this robot.</source>
        <translation>このロボットのブレークポイントを選んでください。</translation>
    </message>
    <message>
        <source>Ago</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Project, outline and palette again</source>
        <translation>プロジェクト、アウトライン、パレットに戻す</translation>
    </message>
    <message>
        <source>Who holds what</source>
        <translation>使用中のリソース</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>ブラックボード</translation>
    </message>
    <message>
        <source>Find in the data</source>
        <translation>データ内を検索</translation>
    </message>
    <message>
        <source>Find a tag</source>
        <translation>タグを検索</translation>
    </message>
    <message>
        <source>since {0}</source>
        <translation>{0} から</translation>
    </message>
    <message>
        <source>new state</source>
        <translation>新しい状態</translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation>{0} 秒</translation>
    </message>
    <message>
        <source>To the event before (Left)</source>
        <translation>前のできごとへ（左矢印）</translation>
    </message>
    <message>
        <source>To the next event (Right)</source>
        <translation>次のできごとへ（右矢印）</translation>
    </message>
    <message>
        <source>See more time (−)</source>
        <translation>長い時間を見る（−）</translation>
    </message>
    <message>
        <source>See less time, more closely (+)</source>
        <translation>短い時間を細かく見る（+）</translation>
    </message>
    <message>
        <source>Everything, from the beginning to the end</source>
        <translation>最初から最後まで</translation>
    </message>
    <message>
        <source>Which data are drawn as curves</source>
        <translation>線で描くデータ</translation>
    </message>
    <message>
        <source>Moments with a name; Page Up and Page Down go from one to another</source>
        <translation>名前を付けた時点。Page Up と Page Down で移ります</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>しおり</translation>
    </message>
    <message>
        <source>Stay here while the robot goes on (Space)</source>
        <translation>ロボットが動いてもここにとどまる（Space）</translation>
    </message>
    <message>
        <source>To the end, and with it (Space)</source>
        <translation>最新へ移り、そのまま追う（Space）</translation>
    </message>
    <message>
        <source>The robot has told no numbers yet</source>
        <translation>ロボットはまだ数値を伝えていません</translation>
    </message>
    <message>
        <source>{0} ms</source>
        <translation>{0} ミリ秒</translation>
    </message>
    <message>
        <source>{0} min</source>
        <translation>{0} 分</translation>
    </message>
    <message>
        <source>{0} h</source>
        <translation>{0} 時間</translation>
    </message>
    <message>
        <source>{0} d</source>
        <translation>{0} 日</translation>
    </message>
    <message>
        <source>result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>said as</source>
        <translation>言い方</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Because of</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>トレース</translation>
    </message>
    <message>
        <source>What kind of event it is.</source>
        <translation>出来事の種類。</translation>
    </message>
    <message>
        <source>What it came from, and when: a click goes there.</source>
        <translation>何から、いつ起きたか。クリックするとそこへ移ります。</translation>
    </message>
    <message>
        <source>What happened.</source>
        <translation>起きたこと。</translation>
    </message>
    <message>
        <source>not kept any more</source>
        <translation>もう残っていません</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Given back</source>
        <translation>返却</translation>
    </message>
    <message>
        <source>Module lost</source>
        <translation>モジュールの切断</translation>
    </message>
    <message>
        <source>Module connected</source>
        <translation>モジュールの接続</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Event ignored</source>
        <translation>無視されたイベント</translation>
    </message>
    <message>
        <source>State left</source>
        <translation>状態の終わり</translation>
    </message>
    <message>
        <source>State entered</source>
        <translation>状態の始まり</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>遷移</translation>
    </message>
    <message>
        <source>Action begins</source>
        <translation>動作の開始</translation>
    </message>
    <message>
        <source>Action ends</source>
        <translation>動作の終了</translation>
    </message>
    <message>
        <source>Action cancelled</source>
        <translation>動作の取り消し</translation>
    </message>
    <message>
        <source>Suspended</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>No longer paused</source>
        <translation>一時停止の解除</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>バージョン</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>そのまま</translation>
    </message>
    <message>
        <source>anew</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>event {0}</source>
        <translation>イベント {0}</translation>
    </message>
    <message>
        <source>unnamed event</source>
        <translation>名前のないイベント</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>the modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>{0} s idle</source>
        <translation>{0} 秒（操作のない間）</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>秒数</translation>
    </message>
    <message>
        <source>Leads to</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Only if</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>成り立つ</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>成り立たない</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Situation {0}</source>
        <translation>状況 {0}</translation>
    </message>
    <message>
        <source>Takes over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Resources</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>必要なもの</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Situations, first that holds</source>
        <translation>状況（上から最初に成り立つもの）</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>What ends {0}</source>
        <translation>{0} を終わらせるもの</translation>
    </message>
    <message>
        <source>Condition of {0}</source>
        <translation>{0} の条件</translation>
    </message>
    <message>
        <source>Drag to where it leads</source>
        <translation>行き先までドラッグ</translation>
    </message>
    <message>
        <source>Note: {0}</source>
        <translation>メモ：{0}</translation>
    </message>
    <message>
        <source>number {0}</source>
        <translation>{0} 番</translation>
    </message>
    <message>
        <source>with a warning</source>
        <translation>警告あり</translation>
    </message>
    <message>
        <source>with an error</source>
        <translation>エラーあり</translation>
    </message>
    <message>
        <source>data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>resource</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>Provides</source>
        <translation>提供するもの</translation>
    </message>
    <message>
        <source>state {0}</source>
        <translation>状態 {0}</translation>
    </message>
    <message>
        <source>every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>what every state has</source>
        <translation>すべての状態に共通のもの</translation>
    </message>
    <message>
        <source>the timeout of {0}</source>
        <translation>{0} の時間切れ</translation>
    </message>
    <message>
        <source>the unnamed event</source>
        <translation>名前のないイベント</translation>
    </message>
    <message>
        <source>Move {0} things</source>
        <translation>{0} 個を移動</translation>
    </message>
    <message>
        <source>Move {0} cards</source>
        <translation>カード {0} 枚を移動</translation>
    </message>
    <message>
        <source>the state before</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>同じ状態</translation>
    </message>
    <message>
        <source>Lead {0} to {1}</source>
        <translation>{0} の行き先を {1} にする</translation>
    </message>
    <message>
        <source>Disconnect {0}</source>
        <translation>{0} のつながりを切る</translation>
    </message>
    <message>
        <source>Add {0} of {1}</source>
        <translation>{1} に {0} を加える</translation>
    </message>
    <message>
        <source>Add {0} of {1} to {2}</source>
        <translation>{1} に、{2} へ行く {0} を加える</translation>
    </message>
    <message>
        <source>existing state</source>
        <translation>すでにある状態</translation>
    </message>
    <message>
        <source>Hello</source>
        <translation>こんにちは</translation>
    </message>
    <message>
        <source>Shall I?</source>
        <translation>よろしいですか</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>No</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Add state {0}</source>
        <translation>状態 {0} を追加</translation>
    </message>
    <message>
        <source>Add state {0} after {1}</source>
        <translation>{1} の後に状態 {0} を加える</translation>
    </message>
    <message>
        <source>Insert state {0}</source>
        <translation>状態 {0} を挿入</translation>
    </message>
    <message>
        <source>Rename state {0} to {1}</source>
        <translation>状態 {0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>Start in {0}</source>
        <translation>{0} から始める</translation>
    </message>
    <message>
        <source>Put {0} card on the grid</source>
        <translation>カード {0} 枚をグリッドに揃える</translation>
    </message>
    <message>
        <source>Put {0} cards on the grid</source>
        <translation>カード {0} 枚をグリッドに揃える</translation>
    </message>
    <message>
        <source>Distribute {0} cards</source>
        <translation>カード {0} 枚を等間隔に並べる</translation>
    </message>
    <message>
        <source>Align {0} cards</source>
        <translation>カード {0} 枚を揃える</translation>
    </message>
    <message>
        <source>the frame {0}</source>
        <translation>枠 {0}</translation>
    </message>
    <message>
        <source>a note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>the screen of {0}</source>
        <translation>{0} の画面</translation>
    </message>
    <message>
        <source>{0} in {1}</source>
        <translation>{1} の {0}</translation>
    </message>
    <message>
        <source>Move {0} to place {1}</source>
        <translation>{0} を {1} 番目に移動</translation>
    </message>
    <message>
        <source>Give {0} no priority in {1}</source>
        <translation>{1} で {0} の優先度をなくす</translation>
    </message>
    <message>
        <source>Give {0} priority {1} in {2}</source>
        <translation>{2} で {0} の優先度を {1} にする</translation>
    </message>
    <message>
        <source>Let {0} use {1}</source>
        <translation>{0} が {1} を使えるようにする</translation>
    </message>
    <message>
        <source>Let {0} not use {1}</source>
        <translation>{0} が {1} を使わないようにする</translation>
    </message>
    <message>
        <source>Let {0} stay as long as it holds</source>
        <translation>{0} を成り立つ間だけ続ける</translation>
    </message>
    <message>
        <source>Let {0} stay {1} s at least</source>
        <translation>{0} を少なくとも {1} 秒続ける</translation>
    </message>
    <message>
        <source>Let {0} end after {1} s</source>
        <translation>{0} を {1} 秒後に終わらせる</translation>
    </message>
    <message>
        <source>Let {0} take over nothing</source>
        <translation>{0} が何も引き継がないようにする</translation>
    </message>
    <message>
        <source>Let {0} take over from {1}</source>
        <translation>{0} が {1} から引き継ぐようにする</translation>
    </message>
    <message>
        <source>Change a note</source>
        <translation>メモを変更</translation>
    </message>
    <message>
        <source>Change data {0}</source>
        <translation>データ {0} を変更</translation>
    </message>
    <message>
        <source>Add situation {0}</source>
        <translation>状況 {0} を追加</translation>
    </message>
    <message>
        <source>Add module {0}</source>
        <translation>モジュール {0} を追加</translation>
    </message>
    <message>
        <source>Add data {0}</source>
        <translation>データ {0} を追加</translation>
    </message>
    <message>
        <source>Rename data {0} to {1}</source>
        <translation>データ {0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>Rename situation {0} to {1}</source>
        <translation>状況 {0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>Rename module {0} to {1}</source>
        <translation>モジュール {0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>Rename resource {0} to {1}</source>
        <translation>リソース {0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>a priority of {0}</source>
        <translation>{0} の優先度</translation>
    </message>
    <message>
        <source>a test of {0}</source>
        <translation>{0} の判定</translation>
    </message>
    <message>
        <source>situation {0}</source>
        <translation>状況 {0}</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{1} の{0}</translation>
    </message>
    <message>
        <source>module {0}</source>
        <translation>モジュール {0}</translation>
    </message>
    <message>
        <source>data {0}</source>
        <translation>データ {0}</translation>
    </message>
    <message>
        <source>resource {0}</source>
        <translation>リソース {0}</translation>
    </message>
    <message>
        <source>Delete {0} things</source>
        <translation>{0} 個を削除</translation>
    </message>
    <message>
        <source>Delete {0}</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>“In every state”</source>
        <translation>「すべての状態」</translation>
    </message>
    <message>
        <source>Rename {0}</source>
        <translation>{0} の名前を変更</translation>
    </message>
    <message>
        <source>Change {0} of {1}</source>
        <translation>{1} の{0}を変更</translation>
    </message>
    <message>
        <source>State {0}</source>
        <translation>状態 {0}</translation>
    </message>
    <message>
        <source>Event of {0}</source>
        <translation>{0} のイベント</translation>
    </message>
    <message>
        <source>Situation {0} of {1}</source>
        <translation>状況 {0}／{1}</translation>
    </message>
    <message>
        <source>Part of every state</source>
        <translation>すべての状態に共通</translation>
    </message>
    <message>
        <source>This always holds.</source>
        <translation>いつも成り立ちます。</translation>
    </message>
    <message>
        <source>This holds while {0}.</source>
        <translation>{0} の間成り立ちます。</translation>
    </message>
    <message>
        <source>Once current it stays until {0}.</source>
        <translation>この状況になると、{0} まで続きます。</translation>
    </message>
    <message>
        <source>Once current it stays for {0} s at least.</source>
        <translation>この状況になると、少なくとも {0} 秒続きます。</translation>
    </message>
    <message>
        <source>Once current it ends after {0} s at the latest.</source>
        <translation>この状況になると、遅くとも {0} 秒で終わります。</translation>
    </message>
    <message>
        <source>It goes before all others.</source>
        <translation>ほかのすべてに優先します。</translation>
    </message>
    <message>
        <source>{0} goes first.</source>
        <translation>{0} が先です。</translation>
    </message>
    <message>
        <source>{0} go first.</source>
        <translation>{0} が先です。</translation>
    </message>
    <message>
        <source>{0} may move the robot.</source>
        <translation>{0} がロボットを動かせます。</translation>
    </message>
    <message>
        <source>{0} may move the robot, in this order.</source>
        <translation>ロボットを使えるのは、順に {0} です。</translation>
    </message>
    <message>
        <source>Nothing may move the robot.</source>
        <translation>何もロボットを使えません。</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} と {1}</translation>
    </message>
    <message>
        <source>is above {0}</source>
        <translation>が {0} より大きい</translation>
    </message>
    <message>
        <source>is below {0}</source>
        <translation>が {0} より小さい</translation>
    </message>
    <message>
        <source>is at least {0}</source>
        <translation>が {0} 以上</translation>
    </message>
    <message>
        <source>is at most {0}</source>
        <translation>が {0} 以下</translation>
    </message>
    <message>
        <source>the situation rests on it</source>
        <translation>今の状況のもとになっています</translation>
    </message>
    <message>
        <source>{0}st of {1}</source>
        <translation>{1} 個中 {0} 番目</translation>
    </message>
    <message>
        <source>{0}nd of {1}</source>
        <translation>{1} 個中 {0} 番目</translation>
    </message>
    <message>
        <source>{0}rd of {1}</source>
        <translation>{1} 個中 {0} 番目</translation>
    </message>
    <message>
        <source>{0}th of {1}</source>
        <translation>{1} 個中 {0} 番目</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>開始前</translation>
    </message>
    <message>
        <source>suspended</source>
        <translation>中断中</translation>
    </message>
    <message>
        <source>{0} is in {1}</source>
        <translation>{0} は {1} にいます</translation>
    </message>
    <message>
        <source>{0}; it waits for {1}</source>
        <translation>{0}。{1} を待っています</translation>
    </message>
    <message>
        <source>Nobody holds {0}.</source>
        <translation>{0} は誰も使っていません。</translation>
    </message>
    <message>
        <source>{0} has held {1} for {2}.</source>
        <translation>{0} は {1} を {2} 使っています。</translation>
    </message>
    <message>
        <source>Waiting for it: {0}.</source>
        <translation>待っているもの: {0}。</translation>
    </message>
    <message>
        <source>{0} waits</source>
        <translation>{0} が待っています</translation>
    </message>
    <message>
        <source>{0} wait</source>
        <translation>{0} が待っています</translation>
    </message>
    <message>
        <source>{0} Priority {1}.</source>
        <translation>{0} 優先度 {1}。</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未設定</translation>
    </message>
    <message>
        <source>and {0} more, {1} does not hold</source>
        <translation>ほか {0} 件、うち {1} 件は成り立たない</translation>
    </message>
    <message>
        <source>and {0} more, {1} do not hold</source>
        <translation>ほか {0} 件、うち {1} 件は成り立たない</translation>
    </message>
    <message>
        <source>until {0}</source>
        <translation>{0} まで</translation>
    </message>
    <message>
        <source>stays {0} s at least</source>
        <translation>少なくとも {0} 秒続きます</translation>
    </message>
    <message>
        <source> or </source>
        <translation> または </translation>
    </message>
    <message>
        <source>a tie, {0}</source>
        <translation>同順位、{0}</translation>
    </message>
    <message>
        <source>nobody asks</source>
        <translation>要求なし</translation>
    </message>
    <message>
        <source>To the difference before (Shift+F4)</source>
        <translation>前の違いへ (Shift+F4)</translation>
    </message>
    <message>
        <source>Next difference</source>
        <translation>次の違い</translation>
    </message>
    <message>
        <source>Where the runs part next after the cursor (F4)</source>
        <translation>カーソルの後で次に実行が分かれるところへ (F4)</translation>
    </message>
    <message>
        <source>Which moments of the runs stand above one another</source>
        <translation>二つの実行のどの時点を上下にそろえるか</translation>
    </message>
    <message>
        <source>Line up</source>
        <translation>そろえる</translation>
    </message>
    <message>
        <source>Let all views show the other run</source>
        <translation>すべての画面でもう一方の実行を見る</translation>
    </message>
    <message>
        <source>Compare no more</source>
        <translation>比べるのをやめる</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>Of the runs beside, none is a recording that all views could show</source>
        <translation>並べた実行の中に、すべての表示に出せる記録がありません</translation>
    </message>
    <message>
        <source>Let all views show another of the runs</source>
        <translation>すべての表示に別の実行を出す</translation>
    </message>
    <message>
        <source>nothing of that</source>
        <translation>それは何もなし</translation>
    </message>
    <message>
        <source>{0}, {1}: {2}</source>
        <translation>{0}、{1}: {2}</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>比べています…</translation>
    </message>
    <message>
        <source>They did the same.</source>
        <translation>同じことをしました。</translation>
    </message>
    <message>
        <source>{0} differences</source>
        <translation>違い {0} か所</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>始まりで</translation>
    </message>
    <message>
        <source>At the first thing that both did</source>
        <translation>どちらもした最初のことで</translation>
    </message>
    <message>
        <source>Where they last did the same, at each difference</source>
        <translation>違いごとに、最後に同じだったところで</translation>
    </message>
    <message>
        <source>At the bookmark “{0}”</source>
        <translation>しおり「{0}」で</translation>
    </message>
    <message>
        <source>No bookmark is in all of the runs</source>
        <translation>すべての実行にあるしおりはありません</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>{0} {1}×, {2}</source>
        <translation>{0} {1} 回、{2}</translation>
    </message>
    <message>
        <source>the state&apos;s speech</source>
        <translation>状態の発話</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>{0} takes away what it took over for {1}</source>
        <translation>{0} は引き継いだ {1} の優先度を取り去る</translation>
    </message>
    <message>
        <source>{0} has priority {1} in {2}</source>
        <translation>{2} で {0} の優先度は {1}</translation>
    </message>
    <message>
        <source>{0} uses {1}</source>
        <translation>{0} は {1} を使う</translation>
    </message>
    <message>
        <source>leads to {0}</source>
        <translation>行き先：{0}</translation>
    </message>
    <message>
        <source>Click to go there, Alt and click to draw the way</source>
        <translation>クリックで移動、Alt＋クリックで線を描く</translation>
    </message>
    <message>
        <source>Something in Situ Studio itself went wrong. Your documents are as they were, and what is not saved is kept: save, and go on. To help us mend it, copy the details into a report.</source>
        <translation>Situ Studio 自体に問題が起きました。文書はそのままで、未保存の変更も保たれています。保存して作業を続けてください。修正のため、詳細をコピーして報告していただけると助かります。</translation>
    </message>
    <message>
        <source>State {0} goes in between here. Alt: it is only moved.</source>
        <translation>状態 {0} をここに挟みます。Alt：移動だけします。</translation>
    </message>
    <message>
        <source>{0} is the key of “{1}”: give that another one first.</source>
        <translation>{0} は「{1}」のキーです。先にそちらを別のキーにしてください。</translation>
    </message>
    <message>
        <source>No key was pressed.</source>
        <translation>キーが押されていません。</translation>
    </message>
    <message>
        <source>{0} alone writes or moves: press it together with Ctrl or Alt.</source>
        <translation>{0} だけでは文字の入力や移動になります。Ctrl か Alt と一緒に押してください。</translation>
    </message>
    <message>
        <source>{0} opens a menu: press another key.</source>
        <translation>{0} はメニューを開くキーです。別のキーを押してください。</translation>
    </message>
    <message>
        <source>{0} moves the selected cards: press another key.</source>
        <translation>{0} は選んだカードを動かすキーです。別のキーを押してください。</translation>
    </message>
    <message>
        <source>row {0}, column {1}</source>
        <translation>{0} 行 {1} 列</translation>
    </message>
    <message>
        <source>the printer does not begin; is it there, and is there room?</source>
        <translation>プリンターが始まりません。つながっていて、空き容量はありますか？</translation>
    </message>
    <message>
        <source>its file is not whole; is there room?</source>
        <translation>ファイルが最後まで書けていません。空き容量はありますか？</translation>
    </message>
    <message>
        <source>only in an application</source>
        <translation>アプリケーションでだけ使えます</translation>
    </message>
    <message>
        <source>only in the graph</source>
        <translation>グラフでだけ使えます</translation>
    </message>
    <message>
        <source>select a state first</source>
        <translation>先に状態を選んでください</translation>
    </message>
    <message>
        <source>select a state, or something of a script, first</source>
        <translation>先に状態かスクリプトの何かを選んでください</translation>
    </message>
    <message>
        <source>select two states first</source>
        <translation>先に状態を二つ選んでください</translation>
    </message>
    <message>
        <source>select a transition first</source>
        <translation>先に遷移を選んでください</translation>
    </message>
    <message>
        <source>select a state or transition first</source>
        <translation>先に状態か遷移を選んでください</translation>
    </message>
    <message>
        <source>select something first</source>
        <translation>先に何か選んでください</translation>
    </message>
    <message>
        <source>select a state that runs a part first</source>
        <translation>先に部品を動かす状態を選んでください</translation>
    </message>
    <message>
        <source>the project has a script already</source>
        <translation>プロジェクトにはもうスクリプトがあります</translation>
    </message>
    <message>
        <source>follow a robot or open a recording first</source>
        <translation>先にロボットに接続するか記録を開いてください</translation>
    </message>
    <message>
        <source>compare two runs first</source>
        <translation>先に二つの実行を比べてください</translation>
    </message>
    <message>
        <source>select a state, transition or situation first</source>
        <translation>先に状態、遷移、状況のどれかを選んでください</translation>
    </message>
    <message>
        <source>connect to a robot first</source>
        <translation>先にロボットに接続してください</translation>
    </message>
    <message>
        <source>a project has one script, and one file with module information</source>
        <translation>スクリプトとモジュール情報のファイルは、プロジェクトに一つずつです</translation>
    </message>
    <message>
        <source>only in the list of modules</source>
        <translation>モジュールの一覧でだけ使えます</translation>
    </message>
    <message>
        <source>only in a script</source>
        <translation>スクリプトでだけ使えます</translation>
    </message>
    <message>
        <source>select what it shall lead from first</source>
        <translation>先に出発点を選んでください</translation>
    </message>
    <message>
        <source>you are in no part</source>
        <translation>部品の中にいません</translation>
    </message>
    <message>
        <source>select a component first</source>
        <translation>先に画面の部品を選んでください</translation>
    </message>
    <message>
        <source>only where states or situations are drawn</source>
        <translation>状態や状況を描いた図でだけ使えます</translation>
    </message>
    <message>
        <source>nothing was undone</source>
        <translation>元に戻したものがありません</translation>
    </message>
    <message>
        <source>select an event, tag or module first</source>
        <translation>先にイベント、タグ、モジュールのどれかを選んでください</translation>
    </message>
    <message>
        <source>no tab was closed</source>
        <translation>閉じたタブがありません</translation>
    </message>
    <message>
        <source>select three states first</source>
        <translation>先に状態を三つ選んでください</translation>
    </message>
    <message>
        <source>nothing was changed</source>
        <translation>変更がありません</translation>
    </message>
    <message>
        <source>only an operator may: your key lets you look only</source>
        <translation>操作者だけができます。この鍵では見ることだけができます</translation>
    </message>
    <message>
        <source>open a document of a project first</source>
        <translation>先にプロジェクトの文書を開いてください</translation>
    </message>
    <message>
        <source>there is no breakpoint</source>
        <translation>ブレークポイントがありません</translation>
    </message>
    <message>
        <source>only in the matrix of a script</source>
        <translation>スクリプトの表でだけ使えます</translation>
    </message>
    <message>
        <source>select data in the graph first</source>
        <translation>先にグラフでデータを選んでください</translation>
    </message>
    <message>
        <source>only in the screen designer</source>
        <translation>画面の設計でだけ使えます</translation>
    </message>
    <message>
        <source>there is no guide yet: drag one out of a ruler</source>
        <translation>ガイドはまだありません。定規から引き出してください</translation>
    </message>
    <message>
        <source>open a document first</source>
        <translation>先に文書を開いてください</translation>
    </message>
    <message>
        <source>select a group of tests first</source>
        <translation>先に判定のまとまりを選んでください</translation>
    </message>
    <message>
        <source>find something first</source>
        <translation>先に何か検索してください</translation>
    </message>
    <message>
        <source>this has no graph</source>
        <translation>これにはグラフがありません</translation>
    </message>
    <message>
        <source>select a priority first</source>
        <translation>先に優先度を選んでください</translation>
    </message>
    <message>
        <source>no recording is open</source>
        <translation>記録が開いていません</translation>
    </message>
    <message>
        <source>there is no problem</source>
        <translation>問題がありません</translation>
    </message>
    <message>
        <source>open a project first</source>
        <translation>先にプロジェクトを開いてください</translation>
    </message>
    <message>
        <source>open a project first, no document alone</source>
        <translation>文書だけでなく、先にプロジェクトを開いてください</translation>
    </message>
    <message>
        <source>no document is open</source>
        <translation>文書が開いていません</translation>
    </message>
    <message>
        <source>select a situation in the graph first</source>
        <translation>先にグラフで状況を選んでください</translation>
    </message>
    <message>
        <source>select tests of a condition first</source>
        <translation>先に条件の判定を選んでください</translation>
    </message>
    <message>
        <source>only while you rehearse</source>
        <translation>リハーサル中だけ使えます</translation>
    </message>
    <message>
        <source>only while you rehearse something else than is drawn</source>
        <translation>リハーサル中の内容と描かれている内容が違うときだけ</translation>
    </message>
    <message>
        <source>no changes were taken into a rehearsal</source>
        <translation>リハーサルに取り入れた変更がありません</translation>
    </message>
    <message>
        <source>only in the graph of an application</source>
        <translation>アプリケーションのグラフでだけ使えます</translation>
    </message>
    <message>
        <source>only in the graph of a script</source>
        <translation>スクリプトのグラフでだけ使えます</translation>
    </message>
    <message>
        <source>Cut {0} pipes</source>
        <translation>{0} 本の線を切る</translation>
    </message>
    <message>
        <source>Only long pipes are folded, and this one is not</source>
        <translation>折りたためるのは長い線だけです。これは長くありません</translation>
    </message>
    <message>
        <source>Arranging {0} cards</source>
        <translation>カード {0} 枚を整列中</translation>
    </message>
    <message>
        <source>There are other cards now than those arranged: arrange them again</source>
        <translation>整列している間にカードが変わりました。もう一度整列してください</translation>
    </message>
    <message>
        <source>Arrange all cards</source>
        <translation>すべてのカードを整列</translation>
    </message>
    <message>
        <source>Select two states to connect</source>
        <translation>つなぐ状態を二つ選んでください</translation>
    </message>
    <message>
        <source>Connect {0} states</source>
        <translation>状態 {0} 個をつなぐ</translation>
    </message>
    <message>
        <source>The layout took longer than {0} s and was given up: all cards stay where they are</source>
        <translation>整列に {0} 秒以上かかったのでやめました。カードはすべて元の場所のままです</translation>
    </message>
    <message>
        <source>it could not be started</source>
        <translation>開始できませんでした</translation>
    </message>
    <message>
        <source>its process ended early</source>
        <translation>処理が途中で終わりました</translation>
    </message>
    <message>
        <source>The layout failed ({0}): all cards stay where they are</source>
        <translation>整列に失敗しました（{0}）。カードはすべて元の場所のままです</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Let {0} look at {1}</source>
        <translation>{0} が {1} を見るようにする</translation>
    </message>
    <message>
        <source>Change a test of {0}</source>
        <translation>{0} の判定を変更</translation>
    </message>
    <message>
        <source>Let {0} ask for {1}</source>
        <translation>{0} が {1} を要求できるようにする</translation>
    </message>
    <message>
        <source>Group tests of {0}: {1}</source>
        <translation>{0} の判定をまとめる：{1}</translation>
    </message>
    <message>
        <source>Take a group of {0} away</source>
        <translation>{0} のまとまりを解く</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>any</source>
        <translation>どれか</translation>
    </message>
    <message>
        <source>{0} would be the last, and the last must always hold: first add one below</source>
        <translation>{0} が最後になりますが、最後の状況は常に成り立たなければなりません。先に下に一つ追加してください</translation>
    </message>
    <message>
        <source>The situations would take over from each other in a circle</source>
        <translation>状況どうしが輪になって引き継ぐことになります</translation>
    </message>
    <message>
        <source>{0} can either stay so long at least, or have an until or an end: not both</source>
        <translation>{0} には、最低継続時間か、終了条件・期限の、どちらか一方しか付けられません</translation>
    </message>
    <message>
        <source>until</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>{0} tests</source>
        <translation>判定 {0} 件</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>asks for {0}</source>
        <translation>{0} を要求</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>{0} in a list</source>
        <translation>一覧の {0}</translation>
    </message>
    <message>
        <source>A pipe leads to another card</source>
        <translation>線は別のカードにつなぎます</translation>
    </message>
    <message>
        <source>Data leads to a condition or a situation, and {0} is neither</source>
        <translation>データの行き先は条件か状況です。{0} はどちらでもありません</translation>
    </message>
    <message>
        <source>A situation leads to a module, or to a situation that it takes over from</source>
        <translation>状況の行き先は、モジュールか、引き継ぎ元の状況です</translation>
    </message>
    <message>
        <source>A module leads to the resources that it uses, and {0} is none</source>
        <translation>モジュールの行き先は、使うリソースです。{0} はリソースではありません</translation>
    </message>
    <message>
        <source>A condition belongs to its situation: drag from data to {0} instead</source>
        <translation>条件はその状況のものです。代わりにデータから {0} へドラッグしてください</translation>
    </message>
    <message>
        <source>New situation</source>
        <translation>新しい状況</translation>
    </message>
    <message>
        <source>{0} holds when</source>
        <translation>{0} が成り立つ条件</translation>
    </message>
    <message>
        <source>{0} holds until</source>
        <translation>{0} の終了条件</translation>
    </message>
    <message>
        <source>New module</source>
        <translation>新しいモジュール</translation>
    </message>
    <message>
        <source>priority</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Take over from {0}</source>
        <translation>{0} から引き継ぐ</translation>
    </message>
    <message>
        <source>Take over nothing</source>
        <translation>何も引き継がない</translation>
    </message>
    <message>
        <source>New situation “{0}”</source>
        <translation>新しい状況「{0}」</translation>
    </message>
    <message>
        <source>New module “{0}”</source>
        <translation>新しいモジュール「{0}」</translation>
    </message>
    <message>
        <source>New resource “{0}”</source>
        <translation>新しいリソース「{0}」</translation>
    </message>
    <message>
        <source>group of tests</source>
        <translation>判定のまとまり</translation>
    </message>
    <message>
        <source>test</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>uses {0}</source>
        <translation>{0} を使う</translation>
    </message>
    <message>
        <source>resource of {0}</source>
        <translation>{0} のリソース</translation>
    </message>
    <message>
        <source>no priority for {0}</source>
        <translation>{0} の優先度なし</translation>
    </message>
    <message>
        <source>taken away in {0}</source>
        <translation>{0} で取り去る</translation>
    </message>
    <message>
        <source>priority {0} for {1}</source>
        <translation>{1} の優先度 {0}</translation>
    </message>
    <message>
        <source>while {0}</source>
        <translation>{0} の間</translation>
    </message>
    <message>
        <source>looked at in {0}</source>
        <translation>{0} で使われます</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>{0} で</translation>
    </message>
    <message>
        <source>used by {0}</source>
        <translation>{0} が使います</translation>
    </message>
    <message>
        <source>priority in {0}</source>
        <translation>{0} での優先度</translation>
    </message>
    <message>
        <source>taken over from {0}</source>
        <translation>{0} から引き継ぎ</translation>
    </message>
    <message>
        <source>Add {0} to the script</source>
        <translation>{0} をスクリプトに追加</translation>
    </message>
    <message>
        <source>This is one document, and the robot runs a whole project.</source>
        <translation>これは一つの文書ですが、ロボットはプロジェクト全体を動かしています。</translation>
    </message>
    <message>
        <source>This is the project {0}, and the robot runs {1}: it is another robot&apos;s.</source>
        <translation>これはプロジェクト {0} ですが、ロボットは {1} を動かしています。別のロボット用です。</translation>
    </message>
    <message>
        <source>{0} leads out of the project: nothing is written.</source>
        <translation>{0} はプロジェクトの外を指しています。何も書き込みません。</translation>
    </message>
    <message>
        <source>{0} is there already: choose another folder.</source>
        <translation>{0} はもうあります。別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>送信中…</translation>
    </message>
    <message>
        <source>The robot did not take it: {0}</source>
        <translation>ロボットは受け取りませんでした：{0}</translation>
    </message>
    <message>
        <source>Version {0} runs, not version {1}.</source>
        <translation>動いているのはバージョン {1} ではなく {0} です。</translation>
    </message>
    <message>
        <source>{0} is paused: let it go on.</source>
        <translation>{0} は一時停止中です。再開してください。</translation>
    </message>
    <message>
        <source>The robot checks version {0}.</source>
        <translation>ロボットがバージョン {0} を調べています。</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>少しの間</translation>
    </message>
    <message>
        <source>Checked. The robot waits for a safe point: {0}.</source>
        <translation>調べ終わりました。ロボットは安全な切り替え時を待っています：{0}。</translation>
    </message>
    <message>
        <source>The robot refused version {0}; version {1} runs on.</source>
        <translation>ロボットはバージョン {0} を断りました。バージョン {1} が動き続けます。</translation>
    </message>
    <message>
        <source>The robot has gone back to version {0} by itself:</source>
        <translation>ロボットは自分でバージョン {0} に戻りました：</translation>
    </message>
    <message>
        <source>Version {0} runs.</source>
        <translation>バージョン {0} が動いています。</translation>
    </message>
    <message>
        <source>For {0} s more the robot goes back to version {1} by itself if it fails.</source>
        <translation>あと {0} 秒の間は、失敗すればロボットが自分でバージョン {1} に戻ります。</translation>
    </message>
    <message>
        <source>Some of it counts when the robot is started again: {0}.</source>
        <translation>ロボットを起動し直すと有効になるもの：{0}。</translation>
    </message>
    <message>
        <source>{0} in state {1} of {2}</source>
        <translation>{2} の状態 {1} の {0}</translation>
    </message>
    <message>
        <source>Version {0} deployed</source>
        <translation>バージョン {0} を配備</translation>
    </message>
    <message>
        <source>Rolled back to version {0}</source>
        <translation>バージョン {0} に戻した</translation>
    </message>
    <message>
        <source>Went back to version {0} by itself</source>
        <translation>自分でバージョン {0} に戻った</translation>
    </message>
    <message>
        <source>Version {0} refused</source>
        <translation>バージョン {0} を断った</translation>
    </message>
    <message>
        <source>Version {0}: what lies in the robot&apos;s own folder</source>
        <translation>バージョン {0}：ロボット自身のフォルダーにあるもの</translation>
    </message>
    <message>
        <source>{0}: no bookmarks can be read: {1}</source>
        <translation>{0}：しおりを読めません：{1}</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>まだ何も起きていません。</translation>
    </message>
    <message>
        <source>now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>{0}, from {1}, {2}</source>
        <translation>{0}、{1} から、{2}</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} を {1} に</translation>
    </message>
    <message>
        <source>{0} changes</source>
        <translation>変化 {0} 回</translation>
    </message>
    <message>
        <source>A priority is a whole number or none, not {0}.</source>
        <translation>優先度は整数か none です。{0} は使えません。</translation>
    </message>
    <message>
        <source>There is nothing to paste.</source>
        <translation>貼り付けるものがありません。</translation>
    </message>
    <message>
        <source>{0} rows and {1} columns do not fit here: begin further up or to the left.</source>
        <translation>{0} 行 {1} 列はここに収まりません。もっと上か左から始めてください。</translation>
    </message>
    <message>
        <source>{0} of {1}: {2}</source>
        <translation>{1} の {0}：{2}</translation>
    </message>
    <message>
        <source>Reading {0}</source>
        <translation>{0} を読み込み中</translation>
    </message>
    <message>
        <source>Connected to the robot now.</source>
        <translation>今ロボットに接続しています。</translation>
    </message>
    <message>
        <source>Moves or uses: {0}</source>
        <translation>動かすもの・使うもの：{0}</translation>
    </message>
    <message>
        <source>Needs: {0}</source>
        <translation>必要なもの：{0}</translation>
    </message>
    <message>
        <source>Provides: {0}</source>
        <translation>提供するもの：{0}</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>起きたこと</translation>
    </message>
    <message>
        <source>Values then</source>
        <translation>そのときの値</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>なぜ？</translation>
    </message>
    <message>
        <source>When it happened: by the clock, or in seconds since the robot started.</source>
        <translation>いつ起きたか。時刻、またはロボットが始まってからの秒数。</translation>
    </message>
    <message>
        <source>What it was, the input that began it first.</source>
        <translation>何が起きたか。きっかけの入力が最初です。</translation>
    </message>
    <message>
        <source>The values that decided it, as they were then.</source>
        <translation>決め手になった、そのときの値。</translation>
    </message>
    <message>
        <source>Ask Why? of a card, an arrow or a row.</source>
        <translation>カード、矢印、行について「なぜ？」を尋ねてください。</translation>
    </message>
    <message>
        <source>It is in their menus; F7 and Shift+F7 ask for what is selected.</source>
        <translation>それぞれのメニューにあります。F7 と Shift+F7 は選んだものについて尋ねます。</translation>
    </message>
    <message>
        <source>Change {0}</source>
        <translation>{0} を変更</translation>
    </message>
    <message>
        <source>Select a state first, then add the {0}.</source>
        <translation>先に状態を選んでから、{0}を加えてください。</translation>
    </message>
    <message>
        <source>Add {0} to {1}</source>
        <translation>{1} に{0}を加える</translation>
    </message>
    <message>
        <source>{0} runs {1}: add the {2} there.</source>
        <translation>{0} は {1} を動かします。{2}はそちらに加えてください。</translation>
    </message>
    <message>
        <source>{0} has a timeout already.</source>
        <translation>{0} にはもう時間切れがあります。</translation>
    </message>
    <message>
        <source>Actions belong to states and events: select one of them first.</source>
        <translation>動作は状態かイベントに付きます。先にどちらかを選んでください。</translation>
    </message>
    <message>
        <source>Add {0}</source>
        <translation>{0}を追加</translation>
    </message>
    <message>
        <source>Select a situation first, then add the condition.</source>
        <translation>先に状況を選んでから、条件を加えてください。</translation>
    </message>
    <message>
        <source>Add condition to {0}</source>
        <translation>{0} に条件を加える</translation>
    </message>
    <message>
        <source>A tag is words of a to z, 0 to 9, _ and - with dots between.</source>
        <translation>タグは a〜z、0〜9、_、- の語を点でつないだものです。</translation>
    </message>
    <message>
        <source>{0} is written by the robot itself only.</source>
        <translation>{0} はロボット自身だけが書き込みます。</translation>
    </message>
    <message>
        <source>Write a tag, with * for one word and ** for any number of words.</source>
        <translation>タグを書いてください。* は一語、** は何語でも表します。</translation>
    </message>
    <message>
        <source>This can not be left empty.</source>
        <translation>空欄にはできません。</translation>
    </message>
    <message>
        <source>A folder inside the project&apos;s own: no .. and no / at its beginning.</source>
        <translation>プロジェクトの中のフォルダーです。.. や先頭の / は使えません。</translation>
    </message>
    <message>
        <source>Write mqtt://HOST or mqtts://HOST; a password stays on the robot.</source>
        <translation>mqtt://ホスト か mqtts://ホスト と書いてください。パスワードはロボット側に置きます。</translation>
    </message>
    <message>
        <source>A topic: + stands for one whole level, # for all that follow.</source>
        <translation>トピックです。+ は一階層、# はそれより下のすべてを表します。</translation>
    </message>
    <message>
        <source>{0} is there already.</source>
        <translation>{0} はもうあります。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>The language in which the word is said so.</source>
        <translation>そう読む言語。</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>表記</translation>
    </message>
    <message>
        <source>The word as it stands in texts.</source>
        <translation>文字に書かれている言葉。</translation>
    </message>
    <message>
        <source>Said</source>
        <translation>読み</translation>
    </message>
    <message>
        <source>The word as it sounds, written as it is spoken.</source>
        <translation>聞こえるとおりに書いた言葉。</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>name, folders of media and scenarios</source>
        <translation>名前、メディアとシナリオのフォルダー</translation>
    </message>
    <message>
        <source>new, order, add, remove</source>
        <translation>新規、順番、追加、取り除く</translation>
    </message>
    <message>
        <source>translate</source>
        <translation>翻訳</translation>
    </message>
    <message>
        <source>How words are said</source>
        <translation>言葉の読み方</translation>
    </message>
    <message>
        <source>readings, pronounce, voice</source>
        <translation>読み、発音、声</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>address, adapter</source>
        <translation>アドレス、アダプター</translation>
    </message>
    <message>
        <source>data, tags, blackboard</source>
        <translation>データ、タグ、ブラックボード</translation>
    </message>
    <message>
        <source>end users, form</source>
        <translation>利用者、フォーム</translation>
    </message>
    <message>
        <source>Kept when the robot restarts</source>
        <translation>再起動しても残すもの</translation>
    </message>
    <message>
        <source>durable, stored</source>
        <translation>残す、保存</translation>
    </message>
    <message>
        <source>Private</source>
        <translation>個人情報</translation>
    </message>
    <message>
        <source>personal data, hidden, operators</source>
        <translation>個人情報、隠す、操作者</translation>
    </message>
    <message>
        <source>map, positions</source>
        <translation>地図、位置</translation>
    </message>
    <message>
        <source>MQTT, broker, sensors, call buttons</source>
        <translation>MQTT、ブローカー、センサー、呼び出しボタン</translation>
    </message>
    <message>
        <source>Names and abbreviations that a voice would say wrongly: it says the second where the first is written. The screen and the trace keep what is written.</source>
        <translation>声が読み間違える名前や略語です。一つ目が書かれているところを二つ目のように読みます。画面と記録は書かれたままです。</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>言葉</translation>
    </message>
    <message>
        <source>Change how {0} is said</source>
        <translation>{0} の読み方を変更</translation>
    </message>
    <message>
        <source>Remove how {0} is said</source>
        <translation>{0} の読み方を取り除く</translation>
    </message>
    <message>
        <source>word</source>
        <translation>言葉</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>The documents are written in the first one; the others have translations.</source>
        <translation>文書は最初の言語で書きます。ほかの言語には翻訳を付けます。</translation>
    </message>
    <message>
        <source>a language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>written in</source>
        <translation>文書の言語</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>{0} を取り除く</translation>
    </message>
    <message>
        <source>Move {0}</source>
        <translation>{0}を移動</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Starts in</source>
        <translation>始まりの状態</translation>
    </message>
    <message>
        <source>The state in which it begins when the robot starts.</source>
        <translation>ロボットが始まるときの最初の状態。</translation>
    </message>
    <message>
        <source>Where several have something to do at one moment, the upper one goes first.</source>
        <translation>同時に複数に出番があるときは、上のものが先です。</translation>
    </message>
    <message>
        <source>an application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>A tag, or several by a pattern: user.* is all that begin with user.</source>
        <translation>タグ、またはまとめて表す書き方。user.* は user で始まるものすべてです。</translation>
    </message>
    <message>
        <source>a tag or pattern</source>
        <translation>タグかパターン</translation>
    </message>
    <message>
        <source>Rename {0} to {1}</source>
        <translation>{0} の名前を {1} に変更</translation>
    </message>
    <message>
        <source>What stands there when the robot starts.</source>
        <translation>ロボットの起動時の値。</translation>
    </message>
    <message>
        <source>Values at the start</source>
        <translation>最初の値</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Its tag: words with dots between, such as user.name.</source>
        <translation>タグ。user.name のように語を点でつなぎます。</translation>
    </message>
    <message>
        <source>Metres along the map&apos;s x axis.</source>
        <translation>地図の x 方向のメートル。</translation>
    </message>
    <message>
        <source>Metres along the map&apos;s y axis.</source>
        <translation>地図の y 方向のメートル。</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Where it looks when it stands there: degrees, 0 is along the x axis.</source>
        <translation>そこでの向き。角度で、0 は x 方向です。</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Where the robot can be sent: metres and degrees in its map.</source>
        <translation>ロボットの行き先。地図上のメートルと角度です。</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>What actions call the place.</source>
        <translation>動作で使う場所の名前。</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>意味</translation>
    </message>
    <message>
        <source>Whether a message is an event, or the new value of a tag.</source>
        <translation>メッセージがイベントか、タグの新しい値か。</translation>
    </message>
    <message>
        <source>Event or tag</source>
        <translation>イベントかタグ</translation>
    </message>
    <message>
        <source>The event that happens, or the tag that gets the value.</source>
        <translation>起こるイベント、または値が入るタグ。</translation>
    </message>
    <message>
        <source>Messages from outside</source>
        <translation>外からのメッセージ</translation>
    </message>
    <message>
        <source>Devices such as fall sensors and call buttons, by an MQTT broker.</source>
        <translation>転倒センサーや呼び出しボタンなど、MQTT ブローカー経由の機器です。</translation>
    </message>
    <message>
        <source>a topic</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Broker</source>
        <translation>ブローカー</translation>
    </message>
    <message>
        <source>Where the messages come from; nothing is heard without one.</source>
        <translation>メッセージの送り元。なければ何も届きません。</translation>
    </message>
    <message>
        <source>Change broker</source>
        <translation>ブローカーを変更</translation>
    </message>
    <message>
        <source>The topic whose messages count.</source>
        <translation>対象にするメッセージのトピック。</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>What stands beside the field.</source>
        <translation>欄の横に出る言葉です。</translation>
    </message>
    <message>
        <source>The tag that is changed; it outlives a restart of the robot.</source>
        <translation>変更されるタグ。ロボットを再起動しても残ります。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>What can be put in there.</source>
        <translation>そこに入れられるもの。</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>選択肢</translation>
    </message>
    <message>
        <source>For a choice: two or more, with commas between.</source>
        <translation>選択用。二つ以上をコンマで区切ります。</translation>
    </message>
    <message>
        <source>Settings for those who use the robot</source>
        <translation>ロボットを使う人のための設定</translation>
    </message>
    <message>
        <source>Each is a field on the robot&apos;s settings page and changes a value there.</source>
        <translation>それぞれロボットの設定ページの欄になり、そこで値を変えられます。</translation>
    </message>
    <message>
        <source>a setting</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Change the setting {0}</source>
        <translation>設定 {0} を変更</translation>
    </message>
    <message>
        <source>first</source>
        <translation>先頭</translation>
    </message>
    <message>
        <source>second</source>
        <translation>2 番目</translation>
    </message>
    <message>
        <source>Remove the setting {0}</source>
        <translation>設定 {0} を取り除く</translation>
    </message>
    <message>
        <source>New setting</source>
        <translation>新しい設定</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>はい・いいえ</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>an event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>たった今</translation>
    </message>
    <message>
        <source>a minute ago</source>
        <translation>1 分前</translation>
    </message>
    <message>
        <source>{0} minutes ago</source>
        <translation>{0} 分前</translation>
    </message>
    <message>
        <source>an hour ago</source>
        <translation>1 時間前</translation>
    </message>
    <message>
        <source>{0} hours ago</source>
        <translation>{0} 時間前</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>昨日</translation>
    </message>
    <message>
        <source>{0} days ago</source>
        <translation>{0} 日前</translation>
    </message>
    <message>
        <source>the situation is {0}</source>
        <translation>状況は {0}</translation>
    </message>
    <message>
        <source>{0} is held by {1}</source>
        <translation>{0} を使うのは {1}</translation>
    </message>
    <message>
        <source>{0} begins: {1} {2}</source>
        <translation>{0} 始まり：{1} {2}</translation>
    </message>
    <message>
        <source>{0} s: {1}</source>
        <translation>{0} 秒：{1}</translation>
    </message>
    <message>
        <source>{0} of {1} well. {2}</source>
        <translation>{1} 件中 {0} 件が成功。{2}</translation>
    </message>
    <message>
        <source>{0} of {1} states</source>
        <translation>状態 {1} 個中 {0} 個</translation>
    </message>
    <message>
        <source>{0} of {1} transitions</source>
        <translation>遷移 {1} 個中 {0} 個</translation>
    </message>
    <message>
        <source>{0} of {1} situations</source>
        <translation>状況 {1} 個中 {0} 個</translation>
    </message>
    <message>
        <source>Came through {0}.</source>
        <translation>通ったもの：{0}。</translation>
    </message>
    <message>
        <source>line {0}, {1} s: expected {2}</source>
        <translation>{0} 行目、{1} 秒：期待は {2}</translation>
    </message>
    <message>
        <source>✓ well</source>
        <translation>✓ 成功</translation>
    </message>
    <message>
        <source>✗ unreadable</source>
        <translation>✗ 読めません</translation>
    </message>
    <message>
        <source>✗ failed</source>
        <translation>✗ 失敗</translation>
    </message>
    <message>
        <source>never reached</source>
        <translation>通らず</translation>
    </message>
    <message>
        <source>no scenario</source>
        <translation>シナリオがありません</translation>
    </message>
    <message>
        <source>{0} % from the left, {1} % from the top</source>
        <translation>左から {0} %、上から {1} %</translation>
    </message>
    <message>
        <source>Phone, {0}</source>
        <translation>スマートフォン、{0}</translation>
    </message>
    <message>
        <source>{0} inch, {1}</source>
        <translation>{0} インチ、{1}</translation>
    </message>
    <message>
        <source>{0} × {1} mm, at least {2} mm is needed</source>
        <translation>{0} × {1} mm（{2} mm 以上必要）</translation>
    </message>
    <message>
        <source>Text {0} mm high, read from {1}&#xa0;m</source>
        <translation>文字の高さ {0} mm、{1} m から読める</translation>
    </message>
    <message>
        <source>Contrast not known: something is behind it</source>
        <translation>後ろに何かあるため、明暗の差は分かりません</translation>
    </message>
    <message>
        <source>Contrast {0} to 1</source>
        <translation>明暗の差 {0} 対 1</translation>
    </message>
    <message>
        <source>Contrast {0} to 1, {1} is needed</source>
        <translation>明暗の差 {0} 対 1（{1} 必要）</translation>
    </message>
    <message>
        <source>No room to the next {0}</source>
        <translation>隣の{0}との間がありません</translation>
    </message>
    <message>
        <source>{0} mm to the next {1}</source>
        <translation>隣の{1}まで {0} mm</translation>
    </message>
    <message>
        <source>{0} × {1} mm</source>
        <translation>{0} × {1} mm</translation>
    </message>
    <message>
        <source>{0} inch</source>
        <translation>{0} インチ</translation>
    </message>
    <message>
        <source>{0}: has {1} MB, and {2} MB is the most: make it smaller first</source>
        <translation>{0}：{1} MB あります。上限は {2} MB です。先に小さくしてください</translation>
    </message>
    <message>
        <source>{0}: the robot takes {1} only</source>
        <translation>{0}：ロボットで使えるのは {1} だけです</translation>
    </message>
    <message>
        <source>{0}: is no file</source>
        <translation>{0}：ファイルではありません</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>{0} is damaged: install situ again</source>
        <translation>{0} が壊れています。situ をもう一度インストールしてください</translation>
    </message>
    <message>
        <source>Two answers</source>
        <translation>二つの答え</translation>
    </message>
    <message>
        <source>List</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>暗証番号</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>お知らせ</translation>
    </message>
    <message>
        <source>Four choices</source>
        <translation>四つの選択</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>{0} takes a number</source>
        <translation>{0} には数値を入れます</translation>
    </message>
    <message>
        <source>{0} is written</source>
        <translation>{0} に書き込みました</translation>
    </message>
    <message>
        <source>nothing happens</source>
        <translation>何も起こりません</translation>
    </message>
    <message>
        <source>stays here</source>
        <translation>ここにとどまります</translation>
    </message>
    <message>
        <source>The time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Nothing happens.</source>
        <translation>何も起こりません。</translation>
    </message>
    <message>
        <source>{0} is not expected here: nothing happens.</source>
        <translation>{0} はここでは待たれていません。何も起こりません。</translation>
    </message>
    <message>
        <source>{0} leads back, to where one came from</source>
        <translation>{0} の行き先は、直前にいた状態です</translation>
    </message>
    <message>
        <source>{0} leads to {1}</source>
        <translation>{0} の行き先は {1}</translation>
    </message>
    <message>
        <source>{0}: stays in {1}</source>
        <translation>{0}：{1} にとどまります</translation>
    </message>
    <message>
        <source>{0} leads to {1}, which is not there</source>
        <translation>{0} の行き先 {1} がありません</translation>
    </message>
    <message>
        <source>{0} leads to {1}: a part runs there, whose screens are in {2}</source>
        <translation>{0} の行き先は {1} です。そこでは部品が動き、画面は {2} にあります</translation>
    </message>
    <message>
        <source>{0} leads to {1}, if its condition holds</source>
        <translation>条件が成り立てば、{0} の行き先は {1} です</translation>
    </message>
    <message>
        <source>{0} situations</source>
        <translation>状況 {0} 個</translation>
    </message>
    <message>
        <source>{0} modules</source>
        <translation>モジュール {0} 個</translation>
    </message>
    <message>
        <source>1 state</source>
        <translation>状態 1 個</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>メモ 1 枚</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>枠 1 個</translation>
    </message>
    <message>
        <source>{0} states</source>
        <translation>状態 {0} 個</translation>
    </message>
    <message>
        <source>{0} notes</source>
        <translation>メモ {0} 個</translation>
    </message>
    <message>
        <source>{0} frames</source>
        <translation>枠 {0} 個</translation>
    </message>
    <message>
        <source>{0} things</source>
        <translation>{0} 個</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Paste {0}</source>
        <translation>{0} を貼り付け</translation>
    </message>
    <message>
        <source>Duplicate {0}</source>
        <translation>{0} を複製</translation>
    </message>
    <message>
        <source>This speech is always said in {0}: it is not translated.</source>
        <translation>この発話はいつも {0} で話されます。翻訳しません。</translation>
    </message>
    <message>
        <source>{0} stands at several places and is translated once: {1} or {2}?</source>
        <translation>{0} は何か所にもあり、訳は一つです。{1} と {2} のどちらにしますか？</translation>
    </message>
    <message>
        <source>A text can not be left empty here: delete it where it stands.</source>
        <translation>ここでは文字を空にできません。置いてある場所で削除してください。</translation>
    </message>
    <message>
        <source>{0} has errors: mend it first.</source>
        <translation>{0} に誤りがあります。先に直してください。</translation>
    </message>
    <message>
        <source>live</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>live, {0} ms behind</source>
        <translation>接続中、{0} ミリ秒遅れ</translation>
    </message>
    <message>
        <source>{0}, its clock is {1} ahead</source>
        <translation>{0}、時計が {1} 進んでいます</translation>
    </message>
    <message>
        <source>{0}, its clock is {1} late</source>
        <translation>{0}、時計が {1} 遅れています</translation>
    </message>
    <message>
        <source>{0}, you can look only</source>
        <translation>{0}、見るだけ</translation>
    </message>
    <message>
        <source>lost {0} ago</source>
        <translation>{0} 前に途絶えました</translation>
    </message>
    <message>
        <source>connecting to {0}</source>
        <translation>{0} に接続しています</translation>
    </message>
    <message>
        <source>nobody answers at {0} for {1}; still trying</source>
        <translation>{0} からは {1} の間応答がありません。試し続けています</translation>
    </message>
    <message>
        <source>no robot</source>
        <translation>ロボットなし</translation>
    </message>
    <message>
        <source>The robot is here, since {0}.</source>
        <translation>ロボットは今ここにいます（{0} から）。</translation>
    </message>
    <message>
        <source>It is suspended: it does not hold what this state uses.</source>
        <translation>中断しています。この状態が使うものを持っていません。</translation>
    </message>
    <message>
        <source>It came here {0}×.</source>
        <translation>ここに {0} 回来ました。</translation>
    </message>
    <message>
        <source>It was here for {0} in all.</source>
        <translation>合わせて {0} ここにいました。</translation>
    </message>
    <message>
        <source>The time ran out {0}×: nobody went on.</source>
        <translation>{0} 回、誰も先へ進めず時間切れになりました。</translation>
    </message>
    <message>
        <source>That is since {0}: what was before is not known here.</source>
        <translation>{0} からの分です。その前のことは、ここでは分かりません。</translation>
    </message>
    <message>
        <source>It is the current situation.</source>
        <translation>今の状況です。</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>現場</translation>
    </message>
    <message>
        <source>The tag that says where the robot is</source>
        <translation>ロボットの居場所を示すタグ</translation>
    </message>
    <message>
        <source>What the robot did is counted for each place: each value of this tag</source>
        <translation>ロボットがしたことを、場所ごと（このタグの値ごと）に数えます</translation>
    </message>
    <message>
        <source>{0} is no tag; write it as pose.place</source>
        <translation>{0} はタグではありません。pose.place のように書いてください</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>記録…</translation>
    </message>
    <message>
        <source>Counts what people did in recorded runs</source>
        <translation>記録した実行で人が何をしたかを数えます</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダー…</translation>
    </message>
    <message>
        <source>Counts all recordings in a folder and those below it</source>
        <translation>フォルダーとその下にあるすべての記録を数えます</translation>
    </message>
    <message>
        <source>On the drawings</source>
        <translation>図に重ねる</translation>
    </message>
    <message>
        <source>How often, how long and where the time ran out; 0× is where nobody came</source>
        <translation>何回、どのくらいの間、どこで時間切れになったか。0× は誰も来なかったところ</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>The whole table, as a spreadsheet takes it (Ctrl+C)</source>
        <translation>表全体を表計算ソフトに貼れる形でコピー (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>The whole table into a file (CSV)</source>
        <translation>表全体をファイル (CSV) に書き出す</translation>
    </message>
    <message>
        <source>Place by</source>
        <translation>場所のタグ</translation>
    </message>
    <message>
        <source>Nothing counted yet</source>
        <translation>まだ何も数えていません</translation>
    </message>
    <message>
        <source>{0} recordings</source>
        <translation>記録 {0} 件</translation>
    </message>
    <message>
        <source>came to {0} of {1} states</source>
        <translation>{1} の状態のうち {0} に来ました</translation>
    </message>
    <message>
        <source>people gave up {0}×</source>
        <translation>あきらめた回数 {0}</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>回数</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>訪問</translation>
    </message>
    <message>
        <source>Of all visits</source>
        <translation>訪問の割合</translation>
    </message>
    <message>
        <source>In all</source>
        <translation>合計</translation>
    </message>
    <message>
        <source>Each time</source>
        <translation>1 回あたり</translation>
    </message>
    <message>
        <source>Time ran out</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>Gave up</source>
        <translation>あきらめた</translation>
    </message>
    <message>
        <source>The application and its state.</source>
        <translation>アプリケーションとその状態。</translation>
    </message>
    <message>
        <source>Where the robot was when it began.</source>
        <translation>始まったときにロボットがいた場所。</translation>
    </message>
    <message>
        <source>How often the robot came to the state.</source>
        <translation>ロボットがその状態に何回来たか。</translation>
    </message>
    <message>
        <source>In how many visits; one lasts from leaving the start state until it is back there.</source>
        <translation>いくつの訪問で来たか。訪問は、最初の状態を離れてから戻るまでの間です。</translation>
    </message>
    <message>
        <source>In how many of all visits at that place.</source>
        <translation>その場所での訪問すべてのうち、どれだけの割合か。</translation>
    </message>
    <message>
        <source>How long the robot was there in all, without the time in which it was suspended.</source>
        <translation>ロボットがそこにいた時間の合計。中断していた時間は除きます。</translation>
    </message>
    <message>
        <source>How long it was there each time.</source>
        <translation>1 回あたり、どのくらいの間いたか。</translation>
    </message>
    <message>
        <source>How often the time of the state ran out.</source>
        <translation>その状態が何回時間切れになったか。</translation>
    </message>
    <message>
        <source>How often the time ran out in a visit while the screen had something to be touched.</source>
        <translation>画面に触れるものがあるのに時間切れになった回数。</translation>
    </message>
    <message>
        <source>{0}, {1}</source>
        <translation>{0}、{1}</translation>
    </message>
    <message>
        <source>never</source>
        <translation>一度もない</translation>
    </message>
    <message>
        <source>{0} %</source>
        <translation>{0} %</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>ほか {0} 件</translation>
    </message>
    <message>
        <source>Situations, data and modules can be copied: select some</source>
        <translation>状況、データ、モジュールをコピーできます。選んでください</translation>
    </message>
    <message>
        <source>Copied: {0}</source>
        <translation>コピーしました：{0}</translation>
    </message>
    <message>
        <source>States, notes and frames can be copied: select some</source>
        <translation>コピーできるのは状態、メモ、枠です。いくつか選んでください</translation>
    </message>
    <message>
        <source>{0} copied</source>
        <translation>{0} をコピーしました</translation>
    </message>
    <message>
        <source>Cut {0}</source>
        <translation>{0} を切り取り</translation>
    </message>
    <message>
        <source>The text on the clipboard has errors. {0}</source>
        <translation>クリップボードの文字に誤りがあります。{0}</translation>
    </message>
    <message>
        <source>There are no states on the clipboard</source>
        <translation>クリップボードに状態がありません</translation>
    </message>
    <message>
        <source>There are no situations, data or modules on the clipboard</source>
        <translation>クリップボードに状況、データ、モジュールがありません</translation>
    </message>
    <message>
        <source>Begin a script of situations</source>
        <translation>状況のスクリプトを始める</translation>
    </message>
    <message>
        <source>Begin the texts in {0}</source>
        <translation>{0} の文を始める</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>メモを加える</translation>
    </message>
    <message>
        <source>Add frame</source>
        <translation>枠を加える</translation>
    </message>
    <message>
        <source>Resize {0}</source>
        <translation>{0} の大きさを変更</translation>
    </message>
    <message>
        <source>Change the text of a note</source>
        <translation>メモの文を変更</translation>
    </message>
    <message>
        <source>Call a frame {0}</source>
        <translation>枠の名前を {0} にする</translation>
    </message>
    <message>
        <source>You have its key</source>
        <translation>鍵を持っています</translation>
    </message>
    <message>
        <source>Open to everybody</source>
        <translation>誰でも接続できます</translation>
    </message>
    <message>
        <source>Needs a key you do not have</source>
        <translation>持っていない鍵が必要です</translation>
    </message>
    <message>
        <source>Not the robot you know</source>
        <translation>知っているロボットではありません</translation>
    </message>
    <message>
        <source>Another version of Situ</source>
        <translation>Situ のバージョンが違います</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>いなくなりました</translation>
    </message>
    <message>
        <source>Only the robot whose key you have can answer, whoever announced it.</source>
        <translation>誰が知らせたものでも、答えられるのは、あなたが鍵を持つロボットだけです。</translation>
    </message>
    <message>
        <source>It runs without keys: whoever is in the network can look, change and deploy, and nobody can tell whether it is the robot that it says it is.</source>
        <translation>鍵なしで動いています。ネットワークにいる人なら誰でも見たり変えたり配備したりできます。名乗っているとおりのロボットかどうかも確かめられません。</translation>
    </message>
    <message>
        <source>Whoever looks after the robot makes you a key, with situ keys add; it goes into the folder of your keys.</source>
        <translation>ロボットの管理者に situ keys add で鍵を作ってもらい、鍵のフォルダーに入れてください。</translation>
    </message>
    <message>
        <source>A robot of this name or address is known here, by another key. Ask whoever looks after it before you connect.</source>
        <translation>この名前かアドレスのロボットは、別の鍵で知られています。接続する前に、管理者に確かめてください。</translation>
    </message>
    <message>
        <source>Robot and studio do not understand each other: update one of them.</source>
        <translation>ロボットとこのエディターのバージョンが合いません。どちらかを更新してください。</translation>
    </message>
    <message>
        <source>It has said goodbye, or has not been heard of for a minute.</source>
        <translation>終了を知らせてきたか、1 分間応答がありません。</translation>
    </message>
    <message>
        <source>the program that looks for them has ended</source>
        <translation>探すプログラムが終わりました</translation>
    </message>
    <message>
        <source>{0} has more events than are kept: the first {1} are not shown.</source>
        <translation>{0} の出来事は残せる数より多いため、最初の {1} 件は表示されません。</translation>
    </message>
    <message>
        <source>{0} holds another run behind this one, which is not shown.</source>
        <translation>{0} には、この後に別の実行が入っています。それは表示されません。</translation>
    </message>
    <message>
        <source>{0} is damaged: what comes behind that is not shown.</source>
        <translation>{0} が壊れています。それより後は表示されません。</translation>
    </message>
    <message>
        <source>{0} ends without its end: the robot was still running, or was killed.</source>
        <translation>{0} は途中で終わっています。ロボットがまだ動いていたか、強制終了されたためです。</translation>
    </message>
    <message>
        <source>Nothing that a robot did is in it.</source>
        <translation>ロボットがしたことは何も入っていません。</translation>
    </message>
    <message>
        <source>{0} is empty: the robot has written nothing into it.</source>
        <translation>{0} は空です。ロボットは何も書いていません。</translation>
    </message>
    <message>
        <source>{0} events are not known</source>
        <translation>出来事 {0} 件が分かりません</translation>
    </message>
    <message>
        <source>Announce it in the network</source>
        <translation>ネットワークに知らせる</translation>
    </message>
    <message>
        <source>A robot that others can reach is found by them when they connect.</source>
        <translation>ほかから届くロボットは、接続のときに見つけてもらえます。</translation>
    </message>
    <message>
        <source>Announce the robot</source>
        <translation>ロボットを知らせる</translation>
    </message>
    <message>
        <source>Do not announce the robot</source>
        <translation>ロボットを知らせない</translation>
    </message>
    <message>
        <source>not now: {0}</source>
        <translation>今は不可: {0}</translation>
    </message>
    <message>
        <source>Write a list, like [1, 2].</source>
        <translation>[1, 2] のようにリストを入力してください。</translation>
    </message>
    <message>
        <source>Write an object, like {&quot;x&quot;: 1}.</source>
        <translation>{&quot;x&quot;: 1} のようにオブジェクトを入力してください。</translation>
    </message>
    <message>
        <source>Write a number.</source>
        <translation>数を入力してください。</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Tab goes from card to card, F6 to the next panel.</source>
        <translation>Tab でカードからカードへ、F6 で次のパネルへ移ります。</translation>
    </message>
    <message>
        <source>reached from {0}</source>
        <translation>{0} から来ます</translation>
    </message>
    <message>
        <source>action on entry of {0}</source>
        <translation>{0} に入ったときの動作</translation>
    </message>
    <message>
        <source>only if {0}</source>
        <translation>{0} のときだけ</translation>
    </message>
    <message>
        <source>said as {0}</source>
        <translation>言い方: {0}</translation>
    </message>
    <message>
        <source>{0}, which does not exist</source>
        <translation>{0}（存在しません）</translation>
    </message>
    <message>
        <source>transition of {0}</source>
        <translation>{0} の遷移</translation>
    </message>
    <message>
        <source>action on the way</source>
        <translation>遷移中の動作</translation>
    </message>
    <message>
        <source>then {0}</source>
        <translation>次は {0}</translation>
    </message>
    <message>
        <source>{0} if it fails</source>
        <translation>失敗したら {0}</translation>
    </message>
    <message>
        <source>About the link</source>
        <translation>接続について</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>script</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>module information</source>
        <translation>モジュール情報</translation>
    </message>
    <message>
        <source>States</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Situations</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>バージョン</translation>
    </message>
    <message>
        <source>Kinds of events that are shown</source>
        <translation>表示する出来事の種類</translation>
    </message>
    <message>
        <source>Only {0}, and what else is chosen here</source>
        <translation>{0} と、ここで選んだほかのものだけ</translation>
    </message>
    <message>
        <source>Which picture?</source>
        <translation>どの画像ですか？</translation>
    </message>
    <message>
        <source>Which movie?</source>
        <translation>どの動画ですか？</translation>
    </message>
    <message>
        <source>Which sound?</source>
        <translation>どの音ですか？</translation>
    </message>
    <message>
        <source>Import a file…</source>
        <translation>ファイルを読み込む…</translation>
    </message>
    <message>
        <source>From data…</source>
        <translation>データから…</translation>
    </message>
    <message>
        <source>What follows?</source>
        <translation>次は？</translation>
    </message>
    <message>
        <source>{0} Type to filter</source>
        <translation>{0} 文字を打つと絞り込みます</translation>
    </message>
    <message>
        <source>Use {0}</source>
        <translation>{0} を使う</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>… and {0} lines more</source>
        <translation>… ほか {0} 行</translation>
    </message>
    <message>
        <source>{0}:</source>
        <translation>{0}:</translation>
    </message>
    <message>
        <source>{0} becomes number {1}</source>
        <translation>{0} を {1} 番にします</translation>
    </message>
    <message>
        <source>Write a name.</source>
        <translation>名前を書いてください。</translation>
    </message>
    <message>
        <source>A name has no / \ : * ? &quot; &lt; &gt; | {{ }} in it and begins with no dot.</source>
        <translation>名前に / \ : * ? &quot; &lt; &gt; | {{ }} は使えず、点で始めることもできません。</translation>
    </message>
    <message>
        <source>A name has no signs in it that can not be seen.</source>
        <translation>名前に、見えない文字は使えません。</translation>
    </message>
    <message>
        <source>becomes {0}</source>
        <translation>{0} になります</translation>
    </message>
    <message>
        <source>the application is called {0} in it</source>
        <translation>その中でアプリケーションは {0} と呼ばれます</translation>
    </message>
    <message>
        <source>1 place that asks for the situation</source>
        <translation>状況を調べている所 1 か所</translation>
    </message>
    <message>
        <source>{0} places that ask for the situation</source>
        <translation>状況を調べている所 {0} か所</translation>
    </message>
    <message>
        <source>1 place that names a module declared in it</source>
        <translation>ここで宣言されたモジュールを挙げている所 1 か所</translation>
    </message>
    <message>
        <source>{0} places that name a module declared in it</source>
        <translation>ここで宣言されたモジュールを挙げている所 {0} か所</translation>
    </message>
    <message>
        <source>the list of applications</source>
        <translation>アプリケーションの一覧</translation>
    </message>
    <message>
        <source>where its texts stand</source>
        <translation>そのテキストの場所</translation>
    </message>
    <message>
        <source>Files of applications and scripts end so: choose another name.</source>
        <translation>その終わり方はアプリケーションとスクリプトのファイルのものです。別の名前にしてください。</translation>
    </message>
    <message>
        <source>the script is called {0} in it</source>
        <translation>その中でスクリプトは {0} と呼ばれます</translation>
    </message>
    <message>
        <source>1 place that names it as a module</source>
        <translation>モジュールとして挙げている所 1 か所</translation>
    </message>
    <message>
        <source>{0} places that name it as a module</source>
        <translation>モジュールとして挙げている所 {0} か所</translation>
    </message>
    <message>
        <source>1 line of the scenario</source>
        <translation>シナリオの 1 行</translation>
    </message>
    <message>
        <source>{0} lines of the scenario</source>
        <translation>シナリオの {0} 行</translation>
    </message>
    <message>
        <source>1 state that runs it</source>
        <translation>それを動かす状態 1 つ</translation>
    </message>
    <message>
        <source>{0} states that run it</source>
        <translation>それを動かす状態 {0} つ</translation>
    </message>
    <message>
        <source>1 state runs it, and will have nothing to run</source>
        <translation>それを動かす状態が 1 つあり、動かすものがなくなります</translation>
    </message>
    <message>
        <source>{0} states run it, and will have nothing to run</source>
        <translation>それを動かす状態が {0} つあり、動かすものがなくなります</translation>
    </message>
    <message>
        <source>which file is its script</source>
        <translation>どのファイルがスクリプトか</translation>
    </message>
    <message>
        <source>which file is its module information</source>
        <translation>どのファイルがモジュール情報か</translation>
    </message>
    <message>
        <source>lines of the scenario</source>
        <translation>シナリオの行</translation>
    </message>
    <message>
        <source>The robot was lost meanwhile and is not asked again: see how it is now, and ask anew.</source>
        <translation>その間にロボットとの接続が切れたため、もう一度は要求しませんでした。今の様子を見て、改めて要求してください。</translation>
    </message>
    <message>
        <source>bookmark {0}</source>
        <translation>しおり {0}</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Take {0} from disk</source>
        <translation>ディスク上の {0} を使う</translation>
    </message>
    <message>
        <source>{0}: both changed the same thing</source>
        <translation>{0}：両方で同じ所が変更されています</translation>
    </message>
    <message>
        <source>Join {0} with disk</source>
        <translation>{0} をディスクと統合</translation>
    </message>
    <message>
        <source>{0} is of another kind now</source>
        <translation>{0} は別の種類の文書になっています</translation>
    </message>
    <message>
        <source>at the left edge of the screen</source>
        <translation>画面の左端</translation>
    </message>
    <message>
        <source>at the right edge of the screen</source>
        <translation>画面の右端</translation>
    </message>
    <message>
        <source>in the middle of the screen, across</source>
        <translation>画面の左右の中央</translation>
    </message>
    <message>
        <source>left edge level with {0}</source>
        <translation>左端が {0} と揃っています</translation>
    </message>
    <message>
        <source>right edge level with {0}</source>
        <translation>右端が {0} と揃っています</translation>
    </message>
    <message>
        <source>middle level with {0}, across</source>
        <translation>左右の中央が {0} と揃っています</translation>
    </message>
    <message>
        <source>at the upper edge of the screen</source>
        <translation>画面の上端</translation>
    </message>
    <message>
        <source>at the lower edge of the screen</source>
        <translation>画面の下端</translation>
    </message>
    <message>
        <source>in the middle of the screen, up and down</source>
        <translation>画面の上下の中央</translation>
    </message>
    <message>
        <source>upper edge level with {0}</source>
        <translation>上端が {0} と揃っています</translation>
    </message>
    <message>
        <source>lower edge level with {0}</source>
        <translation>下端が {0} と揃っています</translation>
    </message>
    <message>
        <source>middle level with {0}, up and down</source>
        <translation>上下の中央が {0} と揃っています</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Open a copy of the example {0}</source>
        <translation>例 {0} のコピーを開く</translation>
    </message>
    <message>
        <source>{0} is not in this project.</source>
        <translation>{0} はこのプロジェクトにありません。</translation>
    </message>
    <message>
        <source>Write another name.</source>
        <translation>別の名前を書いてください。</translation>
    </message>
    <message>
        <source>There is a file {0} already: choose another name.</source>
        <translation>{0} というファイルがもうあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>The {0} {1}.</source>
        <translation>この{0}{1}。</translation>
    </message>
    <message>
        <source>event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>There is an event {0} already: choose another name.</source>
        <translation>{0} というイベントがもうあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>There is a tag {0} already: choose another name.</source>
        <translation>{0} というタグがもうあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>There is a module {0} already: choose another name.</source>
        <translation>{0} というモジュールがもうあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>Setting {0}</source>
        <translation>設定 {0}</translation>
    </message>
    <message>
        <source>Choices differ from each other, and have no comma in them.</source>
        <translation>選択肢は互いに異なり、コンマを含みません。</translation>
    </message>
    <message>
        <source>{0} is taken already.</source>
        <translation>{0} はもう使われています。</translation>
    </message>
    <message>
        <source>documents of this kind have no graph: choose an application or a script</source>
        <translation>この種類の文書にはグラフがありません。アプリケーションかスクリプトを選んでください</translation>
    </message>
    <message>
        <source>there is nothing on the drawing yet</source>
        <translation>図にはまだ何もありません</translation>
    </message>
    <message>
        <source>{0}: end the name of a picture with .svg, .pdf or .png</source>
        <translation>{0}：画像の名前は .svg、.pdf、.png のどれかで終わるようにしてください</translation>
    </message>
    <message>
        <source>{0}: can not be drawn</source>
        <translation>{0}：描けません</translation>
    </message>
    <message>
        <source>a picture of {0} × {1} px is too large: choose a smaller scale, or SVG or PDF</source>
        <translation>{0} × {1} px の画像は大きすぎます。倍率を下げるか、SVG か PDF を選んでください</translation>
    </message>
    <message>
        <source>Write seconds above 0.</source>
        <translation>0 より大きい秒数を入力してください。</translation>
    </message>
    <message>
        <source>Write a whole number, or nothing.</source>
        <translation>整数を入力するか、空にしてください。</translation>
    </message>
    <message>
        <source>{0} is no document of this project</source>
        <translation>{0} はこのプロジェクトの文書ではありません</translation>
    </message>
    <message>
        <source>{0} is inside the project itself: name another folder</source>
        <translation>{0} はプロジェクト自身の中です。別のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>no project is open</source>
        <translation>プロジェクトが開かれていません</translation>
    </message>
    <message>
        <source>{0}: no project could be read</source>
        <translation>{0}：プロジェクトを読めませんでした</translation>
    </message>
    <message>
        <source>{0} is not saved: it has errors, and what they name would be lost</source>
        <translation>{0} は保存されていません。誤りがあり、そこに挙げたものが失われます</translation>
    </message>
    <message>
        <source>{0} has errors: mend them first, or they would be lost</source>
        <translation>{0} に誤りがあります。失われないように、先に直してください</translation>
    </message>
    <message>
        <source>{0}: no project</source>
        <translation>{0}：プロジェクトではありません</translation>
    </message>
    <message>
        <source>it failed in the rehearsal</source>
        <translation>リハーサルで失敗させました</translation>
    </message>
</context>
<context>
    <name>AddTest</name>
    <message>
        <source>Add a test</source>
        <translation>条件を加える</translation>
    </message>
    <message>
        <source>A test</source>
        <translation>条件</translation>
    </message>
</context>
<context>
    <name>AlignRow</name>
    <message>
        <source>To the left edge of the screen</source>
        <translation>画面の左端へ</translation>
    </message>
    <message>
        <source>To the middle, across</source>
        <translation>左右の中央へ</translation>
    </message>
    <message>
        <source>To the right edge of the screen</source>
        <translation>画面の右端へ</translation>
    </message>
    <message>
        <source>To the upper edge of the screen</source>
        <translation>画面の上端へ</translation>
    </message>
    <message>
        <source>To the middle, up and down</source>
        <translation>上下の中央へ</translation>
    </message>
    <message>
        <source>To the lower edge of the screen</source>
        <translation>画面の下端へ</translation>
    </message>
    <message>
        <source>Align {0}</source>
        <translation>{0}を揃える</translation>
    </message>
</context>
<context>
    <name>AlignSeveral</name>
    <message>
        <source>Align</source>
        <translation>揃える</translation>
    </message>
    <message>
        <source>Left edges</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>Middles, one above the other</source>
        <translation>縦に並べて中央</translation>
    </message>
    <message>
        <source>Right edges</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>Upper edges</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>Middles, side by side</source>
        <translation>横に並べて中央</translation>
    </message>
    <message>
        <source>Lower edges</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>Evenly side by side</source>
        <translation>横に等間隔</translation>
    </message>
    <message>
        <source>Evenly one above the other</source>
        <translation>縦に等間隔</translation>
    </message>
</context>
<context>
    <name>ApplicationCanvas</name>
    <message>
        <source>New state “{0}”</source>
        <translation>新しい状態「{0}」</translation>
    </message>
    <message>
        <source>No state yet. Drag State from the palette to here.</source>
        <translation>まだ状態がありません。パレットから「状態」をここにドラッグしてください。</translation>
    </message>
    <message>
        <source>What follows? Select the state, drag the plus at its right edge to an empty place and choose. Or drag State from the palette to here.</source>
        <translation>次は？ 状態を選び、右端の＋を空いた場所へドラッグして選んでください。または、パレットから「状態」をここにドラッグしてください。</translation>
    </message>
</context>
<context>
    <name>ApplicationList</name>
    <message>
        <source>New application…</source>
        <translation>新しいアプリケーション…</translation>
    </message>
    <message>
        <source>New application</source>
        <translation>新しいアプリケーション</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>round</source>
        <translation>巡回</translation>
    </message>
    <message>
        <source>{0} is there already.</source>
        <translation>{0} はもうあります。</translation>
    </message>
    <message>
        <source>start</source>
        <translation>始まり</translation>
    </message>
    <message>
        <source>{0} can not be read: {1}</source>
        <translation>{0} を読み取れません: {1}</translation>
    </message>
    <message>
        <source>{0} is no application.</source>
        <translation>{0} はアプリケーションではありません。</translation>
    </message>
    <message>
        <source>{0} has errors: mend them first, or what they name would be lost.</source>
        <translation>{0} にエラーがあります。そこに挙げたものが失われるので、先に直してください。</translation>
    </message>
    <message>
        <source>Duplicate application {0}</source>
        <translation>アプリケーション {0} を複製</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>{0} を取り除く</translation>
    </message>
    <message>
        <source>Add application {0}</source>
        <translation>アプリケーション {0} を加える</translation>
    </message>
    <message>
        <source>There are errors in the project: mend them first.</source>
        <translation>プロジェクトに誤りがあります。先に直してください。</translation>
    </message>
</context>
<context>
    <name>Authority</name>
    <message>
        <source>nobody</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>表示中</translation>
    </message>
</context>
<context>
    <name>BottomPanels</name>
    <message>
        <source>More panels</source>
        <translation>ほかのパネル</translation>
    </message>
    <message>
        <source>Fold the panel</source>
        <translation>パネルを畳む</translation>
    </message>
    <message>
        <source>Unfold the panel</source>
        <translation>パネルを広げる</translation>
    </message>
</context>
<context>
    <name>Breadcrumbs</name>
    <message>
        <source>Way into the part</source>
        <translation>部品までの道筋</translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation>{0} に戻る</translation>
    </message>
</context>
<context>
    <name>CheckWork</name>
    <message>
        <source>Looking for problems</source>
        <translation>問題を調べています</translation>
    </message>
</context>
<context>
    <name>Choice</name>
    <message>
        <source>{0} (missing)</source>
        <translation>{0}（ありません）</translation>
    </message>
</context>
<context>
    <name>ChoosingMedia</name>
    <message>
        <source>The document has changed meanwhile: choose the file again.</source>
        <translation>その間に書類が変わりました。ファイルを選び直してください。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
</context>
<context>
    <name>ChosenRecording</name>
    <message>
        <source>Reading {0}</source>
        <translation>{0} を読み込み中</translation>
    </message>
</context>
<context>
    <name>ClockBar</name>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Go to what happens next</source>
        <translation>次に起こることまで進む</translation>
    </message>
    <message>
        <source>From the start</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Save as a scenario</source>
        <translation>シナリオとして保存</translation>
    </message>
    <message>
        <source>Time of the rehearsal</source>
        <translation>リハーサルの時間</translation>
    </message>
    <message>
        <source>How fast</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続ける</translation>
    </message>
</context>
<context>
    <name>ColumnSide</name>
    <message>
        <source>Robot at this moment</source>
        <translation>この時点のロボット</translation>
    </message>
</context>
<context>
    <name>CommandedCanvas</name>
    <message>
        <source>All of them are selected already</source>
        <translation>もうすべて選ばれています</translation>
    </message>
    <message>
        <source>Select a state with transitions</source>
        <translation>遷移のある状態を選んでください</translation>
    </message>
    <message>
        <source>Select one state, or one transition</source>
        <translation>状態か遷移を一つ選んでください</translation>
    </message>
    <message>
        <source>They are on the grid already</source>
        <translation>もうグリッドに合っています</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Pasted. This project does not have {0}: copy the files too.</source>
        <translation>貼り付けました。このプロジェクトに {0} がないので、ファイルもコピーしてください。</translation>
    </message>
    <message>
        <source>Delete {0}</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>Situ Studio {0}
Draw what a robot says, shows and does.</source>
        <translation>Situ Studio {0}
ロボットが話し、見せ、行うことを描きます。</translation>
    </message>
</context>
<context>
    <name>ComparingSide</name>
    <message>
        <source>Compare</source>
        <translation>比べる</translation>
    </message>
    <message>
        <source>Another run below this one, and where they part</source>
        <translation>別の実行を下に並べ、どこで分かれるかを見ます</translation>
    </message>
    <message>
        <source>the robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>the rehearsal</source>
        <translation>リハーサル</translation>
    </message>
    <message>
        <source>With a recording…</source>
        <translation>記録と…</translation>
    </message>
    <message>
        <source>With {0}</source>
        <translation>{0} と</translation>
    </message>
    <message>
        <source>Compare no more</source>
        <translation>比べるのをやめる</translation>
    </message>
    <message>
        <source>No difference comes after this.</source>
        <translation>この後に違いはありません。</translation>
    </message>
    <message>
        <source>No difference comes before this.</source>
        <translation>この前に違いはありません。</translation>
    </message>
    <message>
        <source>The runs could not be compared; what happened is in studio.log.</source>
        <translation>実行を比べられませんでした。何が起きたかは studio.log にあります。</translation>
    </message>
</context>
<context>
    <name>ComponentCommands</name>
    <message>
        <source>{0} copied</source>
        <translation>{0} をコピーしました</translation>
    </message>
    <message>
        <source>Cut {0}</source>
        <translation>{0} を切り取り</translation>
    </message>
    <message>
        <source>The components on the clipboard can not be read: copy them again.</source>
        <translation>クリップボードの部品を読み取れません。もう一度コピーしてください。</translation>
    </message>
    <message>
        <source>Select a state first, then paste the components.</source>
        <translation>先に状態を選んでから、画面の部品を貼り付けてください。</translation>
    </message>
    <message>
        <source>{0} runs {1}: paste the components there.</source>
        <translation>{0} は {1} を動かします。画面の部品はそちらに貼り付けてください。</translation>
    </message>
    <message>
        <source>Paste {0}</source>
        <translation>{0} を貼り付け</translation>
    </message>
    <message>
        <source>Duplicate {0}</source>
        <translation>{0} を複製</translation>
    </message>
    <message>
        <source>Pasted. This project does not have {0}: copy the files too.</source>
        <translation>貼り付けました。このプロジェクトには {0} がありません。ファイルもコピーしてください。</translation>
    </message>
    <message>
        <source>{0} components</source>
        <translation>画面の部品 {0} 個</translation>
    </message>
    <message>
        <source>Bring {0} to the front</source>
        <translation>{0} を最前面へ</translation>
    </message>
    <message>
        <source>Bring {0} forward</source>
        <translation>{0} を前面へ</translation>
    </message>
    <message>
        <source>Send {0} backward</source>
        <translation>{0} を背面へ</translation>
    </message>
    <message>
        <source>Send {0} to the back</source>
        <translation>{0} を最背面へ</translation>
    </message>
</context>
<context>
    <name>ConditionEditor</name>
    <message>
        <source>Add a test</source>
        <translation>条件を加える</translation>
    </message>
    <message>
        <source>Change a test</source>
        <translation>条件を変更</translation>
    </message>
    <message>
        <source>Remove a test</source>
        <translation>条件を削除</translation>
    </message>
    <message>
        <source>Remove a group</source>
        <translation>グループを削除</translation>
    </message>
    <message>
        <source>Change a group</source>
        <translation>グループを変更</translation>
    </message>
</context>
<context>
    <name>ConflictDialog</name>
    <message>
        <source>{0} is another one on disk</source>
        <translation>ディスク上の {0} が変わっています</translation>
    </message>
    <message>
        <source>You changed</source>
        <translation>自分の変更</translation>
    </message>
    <message>
        <source>The other program changed</source>
        <translation>別のプログラムの変更</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>両方を残す</translation>
    </message>
    <message>
        <source>Take the one on disk</source>
        <translation>ディスク上のものを使う</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>自分の変更を残す</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>後で決める</translation>
    </message>
    <message>
        <source>{0} is gone: another program removed or renamed it. Keep yours and it is written again when you save.</source>
        <translation>{0} がありません。別のプログラムが削除したか名前を変えました。自分のものを残すと、保存するときに書き直されます。</translation>
    </message>
    <message>
        <source>Another program changed {0}, and it has errors now: {1}. Keep yours and what is there is overwritten when you save.</source>
        <translation>{0} は別のプログラムで変更され、誤りがあります：{1}。自分のものを残すと、保存するときに上書きされます。</translation>
    </message>
    <message>
        <source>Another program changed {0} while you did, at other places: both can be kept. Each choice is a step that Undo takes back.</source>
        <translation>{0} は別のプログラムでも、別の箇所が変更されました。両方を残せます。どの選択も「元に戻す」で取り消せます。</translation>
    </message>
    <message>
        <source>Another program changed {0} again. Below is how yours differs from it.</source>
        <translation>{0} は別のプログラムで再び変更されました。下は自分のものとの違いです。</translation>
    </message>
    <message>
        <source>Another program changed {0} while you did, partly the same things: choose which one stays. Each choice is a step that Undo takes back.</source>
        <translation>{0} は別のプログラムでも変更され、同じところが含まれます。どちらを残すか選んでください。どの選択も「元に戻す」で取り消せます。</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>ほか {0} 件</translation>
    </message>
    <message>
        <source>Nothing that counts: only where things stand in the file.</source>
        <translation>実質的な違いはありません。ファイル内の並びだけです。</translation>
    </message>
</context>
<context>
    <name>ConnectDialog</name>
    <message>
        <source>Connect to a robot</source>
        <translation>ロボットに接続</translation>
    </message>
    <message>
        <source>Found in the network</source>
        <translation>ネットワークで見つかったもの</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Robots found in the network</source>
        <translation>ネットワークで見つかったロボット</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Robots can not be looked for: {0}</source>
        <translation>ロボットを探せません: {0}</translation>
    </message>
    <message>
        <source>Looking for robots… One that only its own machine reaches does not announce itself.</source>
        <translation>ロボットを探しています… 自分の機械からしか届かないロボットは、自分を知らせません。</translation>
    </message>
</context>
<context>
    <name>DeleteDocument</name>
    <message>
        <source>Delete {0}</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>Delete {0}?</source>
        <translation>{0} を削除しますか？</translation>
    </message>
    <message>
        <source>Undo brings it back. When you save, the file goes into the waste basket.</source>
        <translation>「元に戻す」で戻せます。保存すると、ファイルはごみ箱に入ります。</translation>
    </message>
    <message>
        <source>Still refers to what stands in it</source>
        <translation>その中身をまだ参照しているもの</translation>
    </message>
    <message>
        <source>Still refers to it, and will not work any more</source>
        <translation>まだ参照していて、動かなくなるもの</translation>
    </message>
    <message>
        <source>Nothing else refers to it.</source>
        <translation>ほかに参照しているものはありません。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
</context>
<context>
    <name>DeployDialog</name>
    <message>
        <source>Deploy</source>
        <translation>配備</translation>
    </message>
    <message>
        <source>What the robot will do differently</source>
        <translation>ロボットの動きの違い</translation>
    </message>
    <message>
        <source>When</source>
        <translation>時</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>人</translation>
    </message>
    <message>
        <source>Versions on the robot</source>
        <translation>ロボットにあるバージョン</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Do not wait for a safe point longer than</source>
        <translation>安全な切り替え時を待つ最長時間</translation>
    </message>
    <message>
        <source>The robot waits until no action runs; what runs then is broken off.</source>
        <translation>ロボットは動作が終わるまで待ちます。その時間を過ぎると、続いている動作を打ち切ります。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Open the robot&apos;s version…</source>
        <translation>ロボットのバージョンを開く…</translation>
    </message>
    <message>
        <source>As a project of its own, in a window of its own.</source>
        <translation>別のプロジェクトとして、別のウィンドウで開きます。</translation>
    </message>
    <message>
        <source>The robot has not told yet what it runs.</source>
        <translation>ロボットはまだ何を動かしているか伝えていません。</translation>
    </message>
    <message>
        <source>The robot is not there: what differs is told when it is.</source>
        <translation>ロボットが見つかりません。違いは、つながったときに示します。</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>ほか {0} 件</translation>
    </message>
    <message>
        <source>It will act the same; its media may differ.</source>
        <translation>動きは同じです。メディアは違うかもしれません。</translation>
    </message>
    <message>
        <source>Only an operator may deploy: your key lets you look only.</source>
        <translation>配備できるのは操作者だけです。この鍵では見ることだけができます。</translation>
    </message>
    <message>
        <source>Roll back to version {0}</source>
        <translation>バージョン {0} に戻す</translation>
    </message>
    <message>
        <source>Roll back</source>
        <translation>前に戻す</translation>
    </message>
</context>
<context>
    <name>DeployingSide</name>
    <message>
        <source>Where the folder {0} shall be made</source>
        <translation>フォルダー {0} を作る場所</translation>
    </message>
</context>
<context>
    <name>Designer</name>
    <message>
        <source>Screen designer</source>
        <translation>画面デザイナー</translation>
    </message>
    <message>
        <source>Where you are</source>
        <translation>今いる場所</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Template {0} for {1}</source>
        <translation>{1} にひな形「{0}」</translation>
    </message>
    <message>
        <source>The screen is another one now: Undo brings it back.</source>
        <translation>画面を入れ替えました。「元に戻す」で戻せます。</translation>
    </message>
    <message>
        <source>There is nothing on this screen that could be kept.</source>
        <translation>この画面には取っておけるものがありません。</translation>
    </message>
    <message>
        <source>Template {0} is kept for all your projects.</source>
        <translation>ひな形「{0}」を、すべてのプロジェクトで使えるように取っておきました。</translation>
    </message>
    <message>
        <source>Template {0} is removed.</source>
        <translation>ひな形「{0}」を取り除きました。</translation>
    </message>
    <message>
        <source>Reorder {0}</source>
        <translation>{0} の順序を変更</translation>
    </message>
    <message>
        <source>Put {0} into {1}</source>
        <translation>{0} を {1} に入れる</translation>
    </message>
</context>
<context>
    <name>DesignerBar</name>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>The screen on which you look at what you draw</source>
        <translation>描いたものを見る画面の大きさ</translation>
    </message>
    <message>
        <source>Lying</source>
        <translation>横置き</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>縦置き</translation>
    </message>
    <message>
        <source>How the screen stands</source>
        <translation>画面の向き</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>見本</translation>
    </message>
    <message>
        <source>The values that texts stand for while you draw</source>
        <translation>描いている間、文字に入れて見る値</translation>
    </message>
    <message>
        <source>Show what is in every state</source>
        <translation>すべての状態にあるものを表示</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>The screen as a person sees and uses it</source>
        <translation>人が見て使うとおりの画面</translation>
    </message>
    <message>
        <source>Own size…</source>
        <translation>別の大きさ…</translation>
    </message>
    <message>
        <source>Sample values: {0}</source>
        <translation>見本の値：{0}</translation>
    </message>
    <message>
        <source>Sample  {0}</source>
        <translation>見本  {0}</translation>
    </message>
</context>
<context>
    <name>DesignerSheet</name>
    <message>
        <source>missing</source>
        <translation>ありません</translation>
    </message>
</context>
<context>
    <name>DesignerSide</name>
    <message>
        <source>What is on the screen</source>
        <translation>画面にあるもの</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>画面の部品</translation>
    </message>
    <message>
        <source>drag or press</source>
        <translation>ドラッグか押す</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>ひな形</translation>
    </message>
    <message>
        <source>Save this screen as a template</source>
        <translation>この画面をひな形として保存</translation>
    </message>
    <message>
        <source>Show all templates</source>
        <translation>ひな形をすべて表示</translation>
    </message>
    <message>
        <source>On this screen</source>
        <translation>この画面にあるもの</translation>
    </message>
    <message>
        <source>front to back</source>
        <translation>手前から奥へ</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>drag into a text</source>
        <translation>文字へドラッグ</translation>
    </message>
    <message>
        <source>Show fewer templates</source>
        <translation>ひな形を少なく表示</translation>
    </message>
</context>
<context>
    <name>DesigningSide</name>
    <message>
        <source>Save this screen as a template</source>
        <translation>この画面をひな形として保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>Desk</name>
    <message>
        <source>People say</source>
        <translation>人の言葉</translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation>続いているもの</translation>
    </message>
    <message>
        <source>Rehearsal</source>
        <translation>リハーサル</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>any tag = value</source>
        <translation>タグ = 値</translation>
    </message>
    <message>
        <source>Any tag and its value</source>
        <translation>タグとその値</translation>
    </message>
    <message>
        <source>A person says that: {0}</source>
        <translation>人がこう言う：{0}</translation>
    </message>
    <message>
        <source>Ends well</source>
        <translation>うまく終わる</translation>
    </message>
    <message>
        <source>Fails</source>
        <translation>失敗する</translation>
    </message>
    <message>
        <source>its answer, such as {&quot;names&quot;: []}</source>
        <translation>答え（{&quot;names&quot;: []} など）</translation>
    </message>
    <message>
        <source>What {0} answers</source>
        <translation>{0} の答え</translation>
    </message>
</context>
<context>
    <name>Details</name>
    <message>
        <source>Details</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Copy the details</source>
        <translation>詳細をコピー</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>DeviceGround</name>
    <message>
        <source>How large the screen is drawn here</source>
        <translation>ここに描かれた画面の大きさ</translation>
    </message>
    <message>
        <source>{0} %</source>
        <translation>{0} %</translation>
    </message>
</context>
<context>
    <name>DialRow</name>
    <message>
        <source>not set</source>
        <translation>未設定</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open a project: the folder with situ.toml</source>
        <translation>プロジェクトを開く：situ.toml のあるフォルダー</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>部品を加える</translation>
    </message>
    <message>
        <source>Choose a part, or type the name of a new one</source>
        <translation>部品を選ぶか、新しい部品の名前を入力してください</translation>
    </message>
    <message>
        <source>Save the changes to {0}?</source>
        <translation>{0} への変更を保存しますか？</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>画像の書き出し</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Recordings ({0})</source>
        <translation>記録 ({0})</translation>
    </message>
    <message>
        <source>Save as a recording</source>
        <translation>記録として保存</translation>
    </message>
    <message>
        <source>Count recordings</source>
        <translation>記録を数える</translation>
    </message>
    <message>
        <source>Count the recordings of a folder</source>
        <translation>フォルダーの記録を数える</translation>
    </message>
    <message>
        <source>Export the table</source>
        <translation>表を書き出す</translation>
    </message>
    <message>
        <source>Tables ({0})</source>
        <translation>表 ({0})</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>ファイルを選ぶ</translation>
    </message>
    <message>
        <source>Files that the robot takes ({0})</source>
        <translation>ロボットで使えるファイル ({0})</translation>
    </message>
    <message>
        <source>Import translations</source>
        <translation>翻訳の読み込み</translation>
    </message>
    <message>
        <source>Export for a translator</source>
        <translation>翻訳者用に書き出し</translation>
    </message>
    <message>
        <source>{0} is open in this window.</source>
        <translation>このウィンドウでは {0} を開いています。</translation>
    </message>
    <message>
        <source>Where shall the other project be opened?</source>
        <translation>もう一つのプロジェクトをどこで開きますか？</translation>
    </message>
    <message>
        <source>New window</source>
        <translation>新しいウィンドウ</translation>
    </message>
    <message>
        <source>This window</source>
        <translation>このウィンドウ</translation>
    </message>
</context>
<context>
    <name>DiskSide</name>
    <message>
        <source>{0} has errors, and what they name is not shown. It can not be changed here until they are mended in a text editor; then it is read anew.</source>
        <translation>{0} に誤りがあり、その部分は表示されません。テキストエディターで直すまでここでは変更できません。直ると読み直します。</translation>
    </message>
    <message>
        <source>Not saved. {0}. Your changes stay here, and are kept for the next start too.</source>
        <translation>保存できませんでした。{0}。変更はここに残り、次に開くときも保たれます。</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>コピーを保存…</translation>
    </message>
    <message>
        <source>{0} is gone: another program removed or renamed it.</source>
        <translation>{0} がありません。別のプログラムが削除したか名前を変えました。</translation>
    </message>
    <message>
        <source>Another program changed {0}, and it has errors now: {1}</source>
        <translation>{0} は別のプログラムで変更され、誤りがあります：{1}</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>自分の変更を残す</translation>
    </message>
    <message>
        <source>{0} was changed by another program: read anew.</source>
        <translation>{0} は別のプログラムで変更されたので、読み直しました。</translation>
    </message>
    <message>
        <source>Look at the changes…</source>
        <translation>変更を見る…</translation>
    </message>
    <message>
        <source>The folder {0} is gone: it was renamed or removed, or its drive is away. Your documents are still here.</source>
        <translation>フォルダー {0} がありません。名前の変更や削除、またはドライブの取り外しによるものです。文書はここに残っています。</translation>
    </message>
    <message>
        <source>It is back</source>
        <translation>元に戻りました</translation>
    </message>
    <message>
        <source>Show where it is now…</source>
        <translation>今の場所を指定…</translation>
    </message>
    <message>
        <source>The project is saved in {0} now.</source>
        <translation>これからはプロジェクトを {0} に保存します。</translation>
    </message>
    <message>
        <source>Another program changed {0}; you have changed it too.</source>
        <translation>{0} は別のプログラムでも、ここでも変更されています。</translation>
    </message>
</context>
<context>
    <name>DocumentFiles</name>
    <message>
        <source>Rename {0} {1}</source>
        <translation>{0} {1} の名前を変更</translation>
    </message>
    <message>
        <source>It is the only application: a project has at least one.</source>
        <translation>これはただ一つのアプリケーションです。プロジェクトには少なくとも一つ要ります。</translation>
    </message>
    <message>
        <source>A project with several applications needs its script: it says which one goes first.</source>
        <translation>アプリケーションが複数あるプロジェクトにはスクリプトが要ります。どれが優先かを決めるものです。</translation>
    </message>
    <message>
        <source>Delete {0} {1}</source>
        <translation>{0} {1} を削除</translation>
    </message>
    <message>
        <source>{0} has errors: mend them first, or what they name would be lost.</source>
        <translation>{0} にエラーがあります。そこに挙げたものが失われるので、先に直してください。</translation>
    </message>
    <message>
        <source>Another program changed {0}: decide first which one stays.</source>
        <translation>ほかのプログラムが {0} を変えました。どちらを残すか先に決めてください。</translation>
    </message>
    <message>
        <source>A document with errors refers to it: mend it first.</source>
        <translation>エラーのある書類がこれを参照しています。先にそれを直してください。</translation>
    </message>
    <message>
        <source>{0} could not go into the waste basket: it stays in the folder.</source>
        <translation>{0} をごみ箱に入れられませんでした。フォルダーに残っています。</translation>
    </message>
</context>
<context>
    <name>DocumentTabs</name>
    <message>
        <source>Open documents</source>
        <translation>開いている文書</translation>
    </message>
    <message>
        <source>All open documents</source>
        <translation>開いているすべての文書</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>{0}, not saved</source>
        <translation>{0}（未保存）</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close the others</source>
        <translation>ほかを閉じる</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>横に開く</translation>
    </message>
</context>
<context>
    <name>Exchange</name>
    <message>
        <source>{0} texts in {1} are in {2}; {3} of them are to be translated.</source>
        <translation>{1} の文字 {0} 件を {2} に書き出しました。うち {3} 件が未翻訳です。</translation>
    </message>
    <message>
        <source>{0} can not be read: {1}</source>
        <translation>{0} を読めません：{1}</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2}</source>
        <translation>{0} の {1} 行目：{2}</translation>
    </message>
    <message>
        <source>{0} does not say which of the project&apos;s languages it is: name the file as one, such as {1}.po, or choose a text in its column first.</source>
        <translation>{0} がプロジェクトのどの言語か分かりません。{1}.po のように言語名をファイル名にするか、先にその言語の列の文字を選んでください。</translation>
    </message>
    <message>
        <source>{0} has errors: mend it first, or they would be lost.</source>
        <translation>{0} に誤りがあります。失われないように、先に直してください。</translation>
    </message>
    <message>
        <source>Import {0} from {1}</source>
        <translation>{1} から {0} を読み込み</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>読み込みました</translation>
    </message>
    <message>
        <source>{0} new</source>
        <translation>新しいもの {0} 件</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しいもの</translation>
    </message>
    <message>
        <source>{0} changed</source>
        <translation>変わったもの {0} 件</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>変わったもの</translation>
    </message>
    <message>
        <source>{0} the same as before</source>
        <translation>前と同じもの {0} 件</translation>
    </message>
    <message>
        <source>{0} to be looked at, not used yet</source>
        <translation>要確認（まだ使いません） {0} 件</translation>
    </message>
    <message>
        <source>To be looked at (fuzzy)</source>
        <translation>要確認（fuzzy）</translation>
    </message>
    <message>
        <source>{0} unknown to this project, kept aside</source>
        <translation>このプロジェクトにないもの {0} 件（別に取っておきます）</translation>
    </message>
    <message>
        <source>Unknown to this project, kept in the file as obsolete</source>
        <translation>このプロジェクトにないもの（ファイルに残します）</translation>
    </message>
    <message>
        <source>{0} not translated</source>
        <translation>未翻訳 {0} 件</translation>
    </message>
    <message>
        <source>Not translated: what was here stays</source>
        <translation>未翻訳：今あるものを残します</translation>
    </message>
    <message>
        <source>{0} leave out a tag of the text</source>
        <translation>タグが抜けているもの {0} 件</translation>
    </message>
    <message>
        <source>Leave out a tag of the text</source>
        <translation>タグが抜けているもの</translation>
    </message>
    <message>
        <source>{0} words that are said otherwise</source>
        <translation>読みの違うことば {0} 個</translation>
    </message>
    <message>
        <source>Words that are said otherwise now</source>
        <translation>読みの違うことばが入りました</translation>
    </message>
    <message>
        <source>{0} from {1}: {2}.</source>
        <translation>{1} から {0}：{2}。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>The selection</source>
        <translation>選択範囲</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>見えている範囲</translation>
    </message>
    <message>
        <source>Export {0}</source>
        <translation>{0} を書き出す</translation>
    </message>
    <message>
        <source>Of the drawing</source>
        <translation>図の範囲</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>{0} × {1} px</source>
        <translation>{0} × {1} px</translation>
    </message>
    <message>
        <source>{0} × {1} px: too large</source>
        <translation>{0} × {1} px：大きすぎます</translation>
    </message>
</context>
<context>
    <name>ExportingSide</name>
    <message>
        <source>{0} is written.</source>
        <translation>{0} を書き出しました。</translation>
    </message>
    <message>
        <source>Drawing {0}</source>
        <translation>{0} を描画中</translation>
    </message>
    <message>
        <source>{0} is printed.</source>
        <translation>{0} を印刷しました。</translation>
    </message>
    <message>
        <source>{0} — {1}</source>
        <translation>{0} — {1}</translation>
    </message>
    <message>
        <source>Printing {0}</source>
        <translation>{0} を印刷しています</translation>
    </message>
    <message>
        <source>{0} can not be printed: {1}</source>
        <translation>{0} を印刷できません: {1}</translation>
    </message>
</context>
<context>
    <name>FieldSide</name>
    <message>
        <source>Field</source>
        <translation>現場</translation>
    </message>
    <message>
        <source>{0}: there is no recording in it (*.mcap)</source>
        <translation>{0}: 記録 (*.mcap) がありません</translation>
    </message>
    <message>
        <source>Counting recordings</source>
        <translation>記録を数えています</translation>
    </message>
    <message>
        <source>Exported to {0}</source>
        <translation>{0} に書き出しました</translation>
    </message>
    <message>
        <source>The project has no such state any more.</source>
        <translation>その状態はもうプロジェクトにありません。</translation>
    </message>
    <message>
        <source>The recordings could not be counted; what happened is in studio.log.</source>
        <translation>記録を数えられませんでした。何が起きたかは studio.log にあります。</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>New project</source>
        <translation>新しいプロジェクト</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Where shall its folder be?</source>
        <translation>フォルダーを置く場所</translation>
    </message>
    <message>
        <source>This project is open here already.</source>
        <translation>このプロジェクトはここですでに開いています。</translation>
    </message>
    <message>
        <source>Where shall the copy of the example be?</source>
        <translation>例のコピーを置く場所</translation>
    </message>
    <message>
        <source>Where shall the copy of the project be?</source>
        <translation>プロジェクトのコピーを置く場所</translation>
    </message>
    <message>
        <source>Save first: what is saved is exported.</source>
        <translation>先に保存してください。保存されたものが書き出されます。</translation>
    </message>
    <message>
        <source>Where shall the folder for the robot be?</source>
        <translation>ロボット用のフォルダーをどこに置きますか？</translation>
    </message>
    <message>
        <source>Exported to {0}</source>
        <translation>{0} に書き出しました</translation>
    </message>
</context>
<context>
    <name>FindAnything</name>
    <message>
        <source>Find anything, run a command</source>
        <translation>検索、コマンドの実行</translation>
    </message>
    <message>
        <source>What to find or run</source>
        <translation>探すもの、実行するもの</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>見つかったもの</translation>
    </message>
    <message>
        <source>Nothing here has that in its name or text.</source>
        <translation>名前にも文章にも見つかりません。</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>States, texts, events, tags, notes</source>
        <translation>状態、テキスト、イベント、タグ、メモ</translation>
    </message>
    <message>
        <source>Find in the project</source>
        <translation>プロジェクト内を検索</translation>
    </message>
    <message>
        <source>Finds every place in which a text or a name stands.</source>
        <translation>文字や名前が出てくるすべての場所を探します。</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>見つかったもの</translation>
    </message>
    <message>
        <source>Write a word or a name: every place of the project in which it stands is listed here, and Enter goes there.</source>
        <translation>言葉や名前を書くと、プロジェクトの中でそれがある所がすべてここに並び、Enter でそこへ移ります。</translation>
    </message>
    <message>
        <source>F3 goes from one to the next</source>
        <translation>F3 で次へ</translation>
    </message>
    <message>
        <source>Nothing in this project has that.</source>
        <translation>このプロジェクトには見つかりません。</translation>
    </message>
    <message>
        <source>{0} places, the first {1} are shown</source>
        <translation>{0} か所（最初の {1} か所を表示）</translation>
    </message>
    <message>
        <source>{0} places</source>
        <translation>{0} か所</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 か所</translation>
    </message>
</context>
<context>
    <name>FindingSide</name>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Usages of what?</source>
        <translation>何の使用箇所を探しますか？</translation>
    </message>
    <message>
        <source>Rename what?</source>
        <translation>何の名前を変えますか？</translation>
    </message>
    <message>
        <source>Rename everywhere</source>
        <translation>すべての箇所で名前を変更</translation>
    </message>
    <message>
        <source>Another name for the {0} {1}</source>
        <translation>{0}「{1}」の新しい名前</translation>
    </message>
    <message>
        <source>Rename {0} {1} to {2}</source>
        <translation>{0}「{1}」を「{2}」に名前変更</translation>
    </message>
    <message>
        <source>A document with errors mentions {0}: mend it first.</source>
        <translation>誤りのある文書が {0} を使っています。先に直してください。</translation>
    </message>
    <message>
        <source>{0} places follow.</source>
        <translation>{0} か所も変わります。</translation>
    </message>
    <message>
        <source>1 place follows.</source>
        <translation>1 か所も変わります。</translation>
    </message>
    <message>
        <source>Not here: {0}.</source>
        <translation>ここでは変わりません：{0}</translation>
    </message>
    <message>
        <source>Look at the patterns of clear too.</source>
        <translation>「消す」のパターンも確かめてください。</translation>
    </message>
</context>
<context>
    <name>FitList</name>
    <message>
        <source>On this screen: {0}</source>
        <translation>この画面では：{0}</translation>
    </message>
    <message>
        <source>All right</source>
        <translation>問題なし</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>Follower</name>
    <message>
        <source>robot: {0}</source>
        <translation>ロボット: {0}</translation>
    </message>
    <message>
        <source>{0} of {1} is paused</source>
        <translation>{1} の {0} は一時停止中です</translation>
    </message>
    <message>
        <source>{0} is connected</source>
        <translation>{0} に接続しています</translation>
    </message>
    <message>
        <source>, known since {0}</source>
        <translation>、{0} から分かっています</translation>
    </message>
    <message>
        <source>, {0} events missed</source>
        <translation>、出来事 {0} 件が抜けています</translation>
    </message>
    <message>
        <source>, same as it ran</source>
        <translation>、動いていたものと同じ</translation>
    </message>
    <message>
        <source>, project {0}, not {1}</source>
        <translation>、プロジェクトは {1} ではなく {0}</translation>
    </message>
    <message>
        <source>{0}, {1}</source>
        <translation>{0}、{1}</translation>
    </message>
    <message>
        <source>rehearsing, {0:.1f} s</source>
        <translation>リハーサル中、{0:.1f} 秒</translation>
    </message>
    <message>
        <source>{0}; {1}</source>
        <translation>{0}、{1}</translation>
    </message>
    <message>
        <source>replaying {0}</source>
        <translation>再生 {0}</translation>
    </message>
    <message>
        <source>, same as the robot</source>
        <translation>（ロボットと同じ）</translation>
    </message>
    <message>
        <source>, differs here</source>
        <translation>（ロボットと異なる）</translation>
    </message>
</context>
<context>
    <name>Form</name>
    <message>
        <source>nothing, it stays</source>
        <translation>なし（そのまま）</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>This can not be left empty.</source>
        <translation>空にはできません。</translation>
    </message>
    <message>
        <source>Change timeout of {0}</source>
        <translation>{0} の時間切れを変更</translation>
    </message>
    <message>
        <source>Change {0}</source>
        <translation>{0} を変更</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{1} の{0}</translation>
    </message>
</context>
<context>
    <name>Frame</name>
    <message>
        <source>Situ Studio</source>
        <translation>Situ Studio</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>パレット</translation>
    </message>
    <message>
        <source>drag onto the canvas</source>
        <translation>キャンバスへドラッグ</translation>
    </message>
    <message>
        <source>Find in the outline</source>
        <translation>アウトライン内を検索</translation>
    </message>
    <message>
        <source>What is on the screen</source>
        <translation>画面にあるもの</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>インスペクター</translation>
    </message>
    <message>
        <source>Problems and more</source>
        <translation>問題など</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>ツールバー</translation>
    </message>
    <message>
        <source>Find anything, run a command</source>
        <translation>検索、コマンドの実行</translation>
    </message>
</context>
<context>
    <name>Group</name>
    <message>
        <source>This project has no document that can be shown. The problems below say why.</source>
        <translation>このプロジェクトには表示できる文書がありません。理由は下の「問題」にあります。</translation>
    </message>
</context>
<context>
    <name>GroupBox</name>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>How many of the tests in it must hold</source>
        <translation>中の判定がいくつ成り立てばよいか</translation>
    </message>
    <message>
        <source>Remove this group</source>
        <translation>このグループを削除</translation>
    </message>
    <message>
        <source>Nothing in it yet: add a test or a group.</source>
        <translation>まだ何もありません。条件かグループを加えてください。</translation>
    </message>
</context>
<context>
    <name>GuideLine</name>
    <message>
        <source>Arrows move it by 1 %, with Shift by 10 %, with Alt by 0.1 %; Del removes it.</source>
        <translation>矢印キーで 1 %、Shift では 10 %、Alt では 0.1 % 動きます。Del で取り除きます。</translation>
    </message>
    <message>
        <source>Upright guide at {0} %</source>
        <translation>縦のガイド {0} %</translation>
    </message>
    <message>
        <source>Lying guide at {0} %</source>
        <translation>横のガイド {0} %</translation>
    </message>
</context>
<context>
    <name>Guiding</name>
    <message>
        <source>Add a guide</source>
        <translation>ガイドを加える</translation>
    </message>
    <message>
        <source>Remove all guides</source>
        <translation>ガイドをすべて取り除く</translation>
    </message>
    <message>
        <source>Move a guide</source>
        <translation>ガイドを動かす</translation>
    </message>
    <message>
        <source>Remove a guide</source>
        <translation>ガイドを取り除く</translation>
    </message>
</context>
<context>
    <name>HelpSide</name>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>今はできません</translation>
    </message>
</context>
<context>
    <name>HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Back to what was read before</source>
        <translation>前に読んでいたところへ戻る</translation>
    </message>
    <message>
        <source>What the help has</source>
        <translation>ヘルプの内容</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>ヘルプを検索</translation>
    </message>
    <message>
        <source>A word of what you want to know</source>
        <translation>知りたいことの言葉</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>見つかったもの</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>描くもの</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>インスペクター</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Find usages</source>
        <translation>使用箇所を検索</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>何も選ばれていません。</translation>
    </message>
    <message>
        <source>Select one of them to change it.</source>
        <translation>変更するには一つだけ選んでください。</translation>
    </message>
    <message>
        <source>{0} selected</source>
        <translation>{0} 個を選択中</translation>
    </message>
</context>
<context>
    <name>KeyList</name>
    <message>
        <source>Type what you want to do</source>
        <translation>やりたいことを入力</translation>
    </message>
    <message>
        <source>What to look for</source>
        <translation>探すもの</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
</context>
<context>
    <name>LargeExport</name>
    <message>
        <source>{0} can not be printed: {1}</source>
        <translation>{0} を印刷できません: {1}</translation>
    </message>
    <message>
        <source>{0} can not be drawn: {1}</source>
        <translation>{0} を描けません：{1}</translation>
    </message>
    <message>
        <source>its process ended early</source>
        <translation>処理が途中で終わりました</translation>
    </message>
</context>
<context>
    <name>Layers</name>
    <message>
        <source>On this screen</source>
        <translation>この画面にあるもの</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
</context>
<context>
    <name>LinkStatus</name>
    <message>
        <source>What is known of the robot and of the link to it</source>
        <translation>ロボットと接続について分かっていること</translation>
    </message>
    <message>
        <source>viewer</source>
        <translation>閲覧者</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>{0}, {1}</source>
        <translation>{0}、{1}</translation>
    </message>
    <message>
        <source>About the link: {0}</source>
        <translation>接続について: {0}</translation>
    </message>
    <message>
        <source>{0} events/s</source>
        <translation>出来事 {0} 件/秒</translation>
    </message>
    <message>
        <source>Version {0}</source>
        <translation>バージョン {0}</translation>
    </message>
    <message>
        <source>not told; an older one</source>
        <translation>不明（古いもの）</translation>
    </message>
    <message>
        <source>{0}, as here</source>
        <translation>{0}、ここと同じ</translation>
    </message>
    <message>
        <source>{0}; here it is {1}</source>
        <translation>{0}、ここは {1}</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>{0}: you can look only</source>
        <translation>{0}: 見ることだけができます</translation>
    </message>
    <message>
        <source>You are</source>
        <translation>あなたの役割</translation>
    </message>
    <message>
        <source>the project that it was started with</source>
        <translation>開始時のプロジェクト</translation>
    </message>
    <message>
        <source>version {0}</source>
        <translation>バージョン {0}</translation>
    </message>
    <message>
        <source>It runs</source>
        <translation>動いているもの</translation>
    </message>
    <message>
        <source>Its Situ</source>
        <translation>ロボットの Situ</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>まだ分かりません</translation>
    </message>
    <message>
        <source>differ from these here: {0}</source>
        <translation>ここのものと違います: {0}</translation>
    </message>
    <message>
        <source>the same as here</source>
        <translation>ここと同じ</translation>
    </message>
    <message>
        <source>Its documents</source>
        <translation>ロボットの書類</translation>
    </message>
    <message>
        <source>It tells</source>
        <translation>伝わる量</translation>
    </message>
    <message>
        <source>Events kept</source>
        <translation>残っている出来事</translation>
    </message>
</context>
<context>
    <name>Listening</name>
    <message>
        <source>This text can not be heard here</source>
        <translation>この文字はここでは聞けません</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>This project is open in another Situ Studio too. What is saved there is told here before anything is overwritten.</source>
        <translation>このプロジェクトは別の Situ Studio でも開いています。そちらで保存されたものは、上書きする前にここで知らせます。</translation>
    </message>
    <message>
        <source>All right</source>
        <translation>了解</translation>
    </message>
    <message>
        <source>{0} has errors: it can be read, not changed.</source>
        <translation>{0} には誤りがあります。見ることはできますが、変更はできません。</translation>
    </message>
</context>
<context>
    <name>Marking</name>
    <message>
        <source>Add a bookmark here… (B)</source>
        <translation>ここにしおりを付ける…（B）</translation>
    </message>
    <message>
        <source>Remove the bookmark here</source>
        <translation>ここのしおりを取り除く</translation>
    </message>
    <message>
        <source>There are no bookmarks yet</source>
        <translation>まだしおりがありません</translation>
    </message>
</context>
<context>
    <name>MatrixModel</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>tie</source>
        <translation>同順位</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>taken over from {0}</source>
        <translation>{0} から引き継ぎ</translation>
    </message>
    <message>
        <source>with a problem</source>
        <translation>問題あり</translation>
    </message>
    <message>
        <source>priority of {0} in {1}: {2}</source>
        <translation>{1} での {0} の優先度：{2}</translation>
    </message>
    <message>
        <source>Taken away here: {0} can hold nothing.</source>
        <translation>ここで取り去られています。{0} は何も使えません。</translation>
    </message>
    <message>
        <source>Taken over from {0}.</source>
        <translation>{0} から引き継いでいます。</translation>
    </message>
    <message>
        <source>Without this it would be {0}, as in {1}.</source>
        <translation>これがなければ {1} と同じ {0} です。</translation>
    </message>
    <message>
        <source>The same priority as {0}: whoever asks first holds it.</source>
        <translation>{0} と同じ優先度です。先に要求したほうが使います。</translation>
    </message>
    <message>
        <source>{0} in {1}, when all ask: {2}</source>
        <translation>全員が要求したときの {1} の {0}：{2}</translation>
    </message>
    <message>
        <source>{0} in {1}: a tie; whoever asks first holds it, of {2}</source>
        <translation>{1} の {0}：同順位。{2} のうち先に要求したほうが使います</translation>
    </message>
    <message>
        <source>Who holds {0} when all modules ask for all they can use</source>
        <translation>すべてのモジュールが使えるものをすべて要求したとき、{0} を使うもの</translation>
    </message>
    <message>
        <source>{0}, with a problem</source>
        <translation>{0}、問題あり</translation>
    </message>
    <message>
        <source>{0} may ask for: {1}</source>
        <translation>{0} が要求できるもの：{1}</translation>
    </message>
    <message>
        <source>current</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>its condition holds</source>
        <translation>条件が成り立つ</translation>
    </message>
    <message>
        <source>{0}, before all below it</source>
        <translation>{0}、下のものより優先</translation>
    </message>
    <message>
        <source>Takes over from {0}.</source>
        <translation>{0} から引き継ぎます。</translation>
    </message>
</context>
<context>
    <name>MatrixView</name>
    <message>
        <source>Priorities</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Add: {0}</source>
        <translation>追加：{0}</translation>
    </message>
    <message>
        <source>pale: taken over from another situation · right: who holds it when all ask</source>
        <translation>淡色：ほかの状況から引き継ぎ · 右：全員が要求したときに使うもの</translation>
    </message>
    <message>
        <source>{0} is taken already.</source>
        <translation>{0} はもう使われています。</translation>
    </message>
</context>
<context>
    <name>MediaPage</name>
    <message>
        <source>Import…</source>
        <translation>読み込む…</translation>
    </message>
    <message>
        <source>A picture, movie or sound from elsewhere</source>
        <translation>ほかの場所にある画像、動画、音</translation>
    </message>
    <message>
        <source>Drag a row onto a screen; Enter shows where it is used.</source>
        <translation>行を画面にドラッグできます。Enter で使われている場所を示します。</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>メディア</translation>
    </message>
    <message>
        <source>No picture, movie or sound yet: import one.</source>
        <translation>画像、動画、音はまだありません。読み込んでください。</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>使われていません</translation>
    </message>
    <message>
        <source>Used in {0}</source>
        <translation>{0} で使われています</translation>
    </message>
</context>
<context>
    <name>MendingSide</name>
    <message>
        <source>What is selected has no problem.</source>
        <translation>選んだものに問題はありません。</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>{0} more in the list of problems</source>
        <translation>問題の一覧にあと {0} 件</translation>
    </message>
    <message>
        <source>Mend all {0} of this kind</source>
        <translation>同じ種類の {0} 件をすべて直す</translation>
    </message>
    <message>
        <source>Show where it is</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>Accept this warning</source>
        <translation>この警告を認める</translation>
    </message>
    <message>
        <source>It is known and meant: it is told no more.</source>
        <translation>承知のうえのものとして、もう知らせません。</translation>
    </message>
    <message>
        <source>This has changed meanwhile: there is nothing to mend there now.</source>
        <translation>その間に変わったので、もう直すところはありません。</translation>
    </message>
    <message>
        <source>Mended: {0}</source>
        <translation>直しました: {0}</translation>
    </message>
    <message>
        <source>Mending all problems of one kind</source>
        <translation>同じ種類の問題をすべて直しています</translation>
    </message>
    <message>
        <source>These could not be mended: its process ended early. Nothing was changed.</source>
        <translation>直せませんでした。処理が途中で終わりました。何も変わっていません。</translation>
    </message>
    <message>
        <source>The project has changed meanwhile: nothing was mended.</source>
        <translation>その間にプロジェクトが変わったので、何も直していません。</translation>
    </message>
    <message>
        <source>Mend {0} problems of one kind</source>
        <translation>同じ種類の問題 {0} 件を直す</translation>
    </message>
    <message>
        <source>These can not be mended together: mend them one by one.</source>
        <translation>まとめて直せません。一つずつ直してください。</translation>
    </message>
    <message>
        <source>{0} mended, {1} are left.</source>
        <translation>{0} 件を直しました。{1} 件が残っています。</translation>
    </message>
    <message>
        <source>{0} problems mended.</source>
        <translation>問題を {0} 件直しました。</translation>
    </message>
</context>
<context>
    <name>ModuleRow</name>
    <message>
        <source>Asks for {0}; pressed again it gives that back</source>
        <translation>{0} を要求します。もう一度押すと返します</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>{0} asks</source>
        <translation>{0} が要求</translation>
    </message>
    <message>
        <source>It died, or is out of reach: what it asked for and does ends</source>
        <translation>停止したか、届かなくなったとします。要求も動きも終わります</translation>
    </message>
    <message>
        <source>Lose</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>{0} is lost</source>
        <translation>{0} が切れる</translation>
    </message>
    <message>
        <source>What {0} lets the robot do</source>
        <translation>{0} がロボットにさせること</translation>
    </message>
    <message>
        <source>{0}: a value</source>
        <translation>{0}：値</translation>
    </message>
    <message>
        <source>What {0} shall do</source>
        <translation>{0} にさせること</translation>
    </message>
</context>
<context>
    <name>MoreModules</name>
    <message>
        <source>Not in this script</source>
        <translation>このスクリプトにないもの</translation>
    </message>
    <message>
        <source>Drag a module onto a situation, or press Enter to add it.</source>
        <translation>状況の上へドラッグするか、Enter で追加します。</translation>
    </message>
    <message>
        <source>an application of this project</source>
        <translation>このプロジェクトのアプリケーション</translation>
    </message>
    <message>
        <source>tells nothing of itself</source>
        <translation>説明なし</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>Write a whole number.</source>
        <translation>整数を入力してください。</translation>
    </message>
    <message>
        <source>Write a number.</source>
        <translation>数を入力してください。</translation>
    </message>
    <message>
        <source>Write a number above 0.</source>
        <translation>0 より大きい数を入力してください。</translation>
    </message>
</context>
<context>
    <name>OperatingSide</name>
    <message>
        <source>Breakpoints</source>
        <translation>ブレークポイント</translation>
    </message>
    <message>
        <source>{0} is paused at {1}</source>
        <translation>{0} は {1} で止まっています</translation>
    </message>
    <message>
        <source>{0} is paused at {1}, at breakpoint {2}</source>
        <translation>{0} は {1} のブレークポイント {2} で止まっています</translation>
    </message>
</context>
<context>
    <name>Outline</name>
    <message>
        <source>Find a state</source>
        <translation>状態を検索</translation>
    </message>
    <message>
        <source>Find in the outline</source>
        <translation>アウトライン内を検索</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>Find a module</source>
        <translation>モジュールを検索</translation>
    </message>
    <message>
        <source>no module information</source>
        <translation>モジュール情報なし</translation>
    </message>
    <message>
        <source>an application of this project</source>
        <translation>このプロジェクトのアプリケーション</translation>
    </message>
</context>
<context>
    <name>OwnDevice</name>
    <message>
        <source>Own size</source>
        <translation>別の大きさ</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source> inches</source>
        <translation> インチ</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Diagonal</source>
        <translation>対角線</translation>
    </message>
</context>
<context>
    <name>PagesSide</name>
    <message>
        <source>Texts</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Media</source>
        <translation>メディア</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>languages, translations</source>
        <translation>言語、翻訳</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>{0} has errors: mend it first, or they would be lost.</source>
        <translation>{0} に誤りがあります。失われないように、先に直してください。</translation>
    </message>
    <message>
        <source>Its name or code, such as Japanese, 日本語, ja or pt-BR</source>
        <translation>名前かコード（Japanese、日本語、ja、pt-BR など）</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>言語を追加</translation>
    </message>
    <message>
        <source>{0} is no language: write its name, or a code such as ja or pt-BR.</source>
        <translation>{0} という言語はありません。名前か、ja や pt-BR のようなコードを書いてください。</translation>
    </message>
    <message>
        <source>Add {0}</source>
        <translation>{0}を追加</translation>
    </message>
</context>
<context>
    <name>PairsEditor</name>
    <message>
        <source>Add a {0}</source>
        <translation>{0}を加える</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Change a {0}</source>
        <translation>{0}を変更</translation>
    </message>
    <message>
        <source>Remove a {0}</source>
        <translation>{0}を削除</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Open a drawing to add to it.</source>
        <translation>図を開くと、加えられます。</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>On its screen</source>
        <translation>画面に出すもの</translation>
    </message>
</context>
<context>
    <name>PanelsSide</name>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>What is selected in a drawing can be changed here.</source>
        <translation>図で選んだものをここで変えられます。</translation>
    </message>
    <message>
        <source>Undo: {0}</source>
        <translation>元に戻す：{0}</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo: {0}</source>
        <translation>やり直す：{0}</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Situ Studio</source>
        <translation>Situ Studio</translation>
    </message>
    <message>
        <source>{0}{1} — Situ Studio</source>
        <translation>{0}{1} — Situ Studio</translation>
    </message>
</context>
<context>
    <name>PartsSide</name>
    <message>
        <source>{0} is not in this project.</source>
        <translation>{0} はこのプロジェクトにありません。</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>部品にする</translation>
    </message>
    <message>
        <source>Name of the part</source>
        <translation>部品の名前</translation>
    </message>
    <message>
        <source>Make a part: {0}</source>
        <translation>部品にする：{0}</translation>
    </message>
    <message>
        <source>{0} has {1} states and {2} ways out: double-click it to look inside.</source>
        <translation>{0} には状態が {1} 個、出口が {2} 個あります。ダブルクリックすると中を見られます。</translation>
    </message>
    <message>
        <source>{0} is a part now; in scenarios its states are {1}/… from here: {2}.</source>
        <translation>{0} は部品になりました。シナリオでは、その状態はこれから {1}/… になります：{2}</translation>
    </message>
    <message>
        <source>Dissolve part {0}</source>
        <translation>部品 {0} を解く</translation>
    </message>
    <message>
        <source>{0} runs this application: it can not be a part of it.</source>
        <translation>{0} はこのアプリケーションを動かしているので、その部品にはできません。</translation>
    </message>
    <message>
        <source>Add part {0}</source>
        <translation>部品 {0} を追加</translation>
    </message>
    <message>
        <source>{0} has errors: it can be read, not changed.</source>
        <translation>{0} には誤りがあります。見ることはできますが、変更はできません。</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Like the system ({0} %)</source>
        <translation>システムと同じ ({0} %)</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Press the new key</source>
        <translation>新しいキーを押してください</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>初期値に戻す</translation>
    </message>
    <message>
        <source>The command has its usual key again.</source>
        <translation>コマンドのキーを初期値に戻しました。</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて初期値に戻す</translation>
    </message>
    <message>
        <source>Every command has its usual key again.</source>
        <translation>すべてのキーを初期値に戻しました。</translation>
    </message>
    <message>
        <source>Click into the field and press the new key.</source>
        <translation>欄をクリックして新しいキーを押してください。</translation>
    </message>
    <message>
        <source>Choose a command to give it another key.</source>
        <translation>キーを変えるコマンドを選んでください。</translation>
    </message>
</context>
<context>
    <name>PreviewPage</name>
    <message>
        <source>The movie ends</source>
        <translation>動画が終わる</translation>
    </message>
    <message>
        <source>The movie can not be played</source>
        <translation>動画を再生できない</translation>
    </message>
</context>
<context>
    <name>PreviewWindow</name>
    <message>
        <source>Preview, {0}</source>
        <translation>プレビュー、{0}</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>一つ戻る</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>What else leads on from here than a press</source>
        <translation>押すこと以外で、ここから先へ進むもの</translation>
    </message>
    <message>
        <source>Conditions and times are left out</source>
        <translation>条件と時間は考えません</translation>
    </message>
    <message>
        <source>Of several events of one name the first is taken, and nothing is spoken.</source>
        <translation>同じ名前のイベントが複数あれば最初のものを選びます。何も話しません。</translation>
    </message>
    <message>
        <source>Press what is on the screen; Esc closes</source>
        <translation>画面にあるものを押してください。Esc で閉じます</translation>
    </message>
    <message>
        <source>The time runs out</source>
        <translation>時間切れになる</translation>
    </message>
</context>
<context>
    <name>PrioritiesEditor</name>
    <message>
        <source>Priority of {0}</source>
        <translation>{0} の優先度</translation>
    </message>
    <message>
        <source>Add a priority for {0}</source>
        <translation>{0} の優先度を加える</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>taken over</source>
        <translation>引き継ぎ</translation>
    </message>
    <message>
        <source>Change the priority of {0}</source>
        <translation>{0} の優先度を変更</translation>
    </message>
    <message>
        <source>Remove the priority of {0}</source>
        <translation>{0} の優先度を削除</translation>
    </message>
</context>
<context>
    <name>Problems</name>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>問題はありません。</translation>
    </message>
    <message>
        <source>Ctrl+Enter: {0}</source>
        <translation>Ctrl+Enter：{0}</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Show {0} more like these</source>
        <translation>同様のものをあと {0} 件表示</translation>
    </message>
    <message>
        <source>Show only {0} of these {1}</source>
        <translation>{1} 件のうち {0} 件だけ表示</translation>
    </message>
</context>
<context>
    <name>ProjectForm</name>
    <message>
        <source>Every robot</source>
        <translation>すべてのロボット</translation>
    </message>
    <message>
        <source>This robot</source>
        <translation>このロボット</translation>
    </message>
    <message>
        <source>Where it counts</source>
        <translation>適用先</translation>
    </message>
    <message>
        <source>What is other on this robot than in the project; it is not deployed.</source>
        <translation>プロジェクトと違う、このロボットだけの値です。配備されません。</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>What it is called</source>
        <translation>呼び名</translation>
    </message>
    <message>
        <source>Media folder</source>
        <translation>メディアのフォルダー</translation>
    </message>
    <message>
        <source>Pictures, movies and sounds</source>
        <translation>絵、動画、音</translation>
    </message>
    <message>
        <source>Scenario folder</source>
        <translation>シナリオのフォルダー</translation>
    </message>
    <message>
        <source>What is played as a test</source>
        <translation>テストとして再生するもの</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Where it is reached, such as tcp://127.0.0.1:5570</source>
        <translation>接続先。tcp://127.0.0.1:5570 など</translation>
    </message>
    <message>
        <source>Adapter</source>
        <translation>アダプター</translation>
    </message>
    <message>
        <source>What drives it: sim is the simulated robot</source>
        <translation>動かすもの。sim は模擬ロボットです</translation>
    </message>
    <message>
        <source>What stands on the blackboard before anything happens, such as the language or the address of a service.</source>
        <translation>何かが起こる前にブラックボードにある値。言語やサービスのアドレスなどです。</translation>
    </message>
    <message>
        <source>Kept when the robot restarts</source>
        <translation>再起動しても残すもの</translation>
    </message>
    <message>
        <source>Values that outlive a restart: medication.* is all below medication.</source>
        <translation>再起動しても残る値。medication.* は medication の下すべてです。</translation>
    </message>
    <message>
        <source>Private</source>
        <translation>個人情報</translation>
    </message>
    <message>
        <source>Shown as ••• to all but operators in traces and recordings.</source>
        <translation>記録では、操作者以外には ••• と表示されます。</translation>
    </message>
</context>
<context>
    <name>ProjectMenu</name>
    <message>
        <source>Add to the project</source>
        <translation>プロジェクトに加える</translation>
    </message>
    <message>
        <source>One file alone is open: nothing can be added beside it.</source>
        <translation>開いているのはファイル一つだけです。ほかに加えることはできません。</translation>
    </message>
    <message>
        <source>What modules say of themselves</source>
        <translation>モジュールが自分について言うこと</translation>
    </message>
    <message>
        <source>Language…</source>
        <translation>言語…</translation>
    </message>
    <message>
        <source>What the project is</source>
        <translation>プロジェクトの設定</translation>
    </message>
    <message>
        <source>Begin module information</source>
        <translation>モジュール情報を始める</translation>
    </message>
</context>
<context>
    <name>ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>All texts, spoken, shown and heard, in every language</source>
        <translation>話す・見せる・聞き取る文字のすべてを、すべての言語で</translation>
    </message>
    <message>
        <source>media</source>
        <translation>メディア</translation>
    </message>
    <message>
        <source>Pictures, movies and sounds, and where each is used</source>
        <translation>画像、動画、音と、それぞれが使われている場所</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
</context>
<context>
    <name>RaisingDialog</name>
    <message>
        <source>Raise an event</source>
        <translation>イベントを起こす</translation>
    </message>
    <message>
        <source>Expected now</source>
        <translation>今待たれているもの</translation>
    </message>
    <message>
        <source>Nothing is expected now</source>
        <translation>今待たれているものはありません</translation>
    </message>
    <message>
        <source>Events that are expected now</source>
        <translation>今待たれているイベント</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>起こす</translation>
    </message>
</context>
<context>
    <name>RangeEdits</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Give {0} the priority {1} in {2}</source>
        <translation>{2} で {0} の優先度を {1} にする</translation>
    </message>
    <message>
        <source>Clear {0}</source>
        <translation>{0} を消去</translation>
    </message>
    <message>
        <source>This is taken over from {0}: type none to take it away here.</source>
        <translation>{0} から引き継いだものです。ここで取り去るには none と入力してください。</translation>
    </message>
    <message>
        <source>{0} copied</source>
        <translation>{0} をコピーしました</translation>
    </message>
    <message>
        <source>Paste {0}</source>
        <translation>{0} を貼り付け</translation>
    </message>
    <message>
        <source>Fill {0}</source>
        <translation>{0} を埋める</translation>
    </message>
    <message>
        <source>{0} priorities</source>
        <translation>優先度 {0} 個</translation>
    </message>
    <message>
        <source>{0} in {1}</source>
        <translation>{1} の {0}</translation>
    </message>
</context>
<context>
    <name>ReadingRecording</name>
    <message>
        <source>{0}: event {1} lacks “{2}”; give what situ run --record wrote</source>
        <translation>{0}: 出来事 {1} に「{2}」がありません。situ run --record が書いたものを指定してください</translation>
    </message>
    <message>
        <source>{0}: event {1} is none of a robot&apos;s; give what situ run --record wrote</source>
        <translation>{0}: 出来事 {1} はロボットのものではありません。situ run --record が書いたものを指定してください</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Remove from the list</source>
        <translation>一覧から取り除く</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>もうありません</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>場所を指定…</translation>
    </message>
    <message>
        <source>Say where this project is now</source>
        <translation>プロジェクトの今の場所を指定します</translation>
    </message>
    <message>
        <source>Projects that you open will be listed here.</source>
        <translation>開いたプロジェクトがここに並びます。</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Unsaved changes can not be kept for the next start ({0}): save soon</source>
        <translation>保存していない変更を次回のために取っておけません（{0}）。早めに保存してください</translation>
    </message>
    <message>
        <source>There are changes to {0} of {1} that were not saved.</source>
        <translation>{1} の {0} に、保存されなかった変更があります。</translation>
    </message>
    <message>
        <source>Bring them back</source>
        <translation>復元する</translation>
    </message>
    <message>
        <source>Forget them</source>
        <translation>破棄する</translation>
    </message>
    <message>
        <source>Bring back unsaved changes</source>
        <translation>保存されなかった変更を復元</translation>
    </message>
</context>
<context>
    <name>RehearsingSide</name>
    <message>
        <source>Rehearsal</source>
        <translation>リハーサル</translation>
    </message>
    <message>
        <source>End the rehearsal</source>
        <translation>リハーサルを終える</translation>
    </message>
    <message>
        <source>Say in the project&apos;s form in which folder its scenarios lie.</source>
        <translation>プロジェクトの入力欄で、シナリオのフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>Saved {0}</source>
        <translation>{0} に保存</translation>
    </message>
    <message>
        <source>Mend the errors first, then the project can run.</source>
        <translation>先にエラーを直すと、プロジェクトを動かせます。</translation>
    </message>
</context>
<context>
    <name>RenameDocument</name>
    <message>
        <source>Rename {0}</source>
        <translation>{0} の名前を変更</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>ファイルの名前</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>変わるもの</translation>
    </message>
    <message>
        <source>All of it is one step, which Undo takes back; files change when you save.</source>
        <translation>すべてが一つの操作で、「元に戻す」で戻せます。ファイルは保存したときに変わります。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前の変更</translation>
    </message>
    <message>
        <source>The script itself is called so too</source>
        <translation>スクリプト自体もこの名前にする</translation>
    </message>
    <message>
        <source>The script is called so too, not {0}</source>
        <translation>スクリプトも {0} ではなくこの名前にする</translation>
    </message>
    <message>
        <source>The application itself is called so too</source>
        <translation>アプリケーション自体もこの名前にする</translation>
    </message>
    <message>
        <source>The application is called so too, not {0}</source>
        <translation>アプリケーションも {0} ではなくこの名前にする</translation>
    </message>
</context>
<context>
    <name>RobotLink</name>
    <message>
        <source>The robot does not answer. It is looked for; ask again once it is there.</source>
        <translation>ロボットが応答しません。探しています。見つかったら、もう一度要求してください。</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>ロボットに接続していません。</translation>
    </message>
</context>
<context>
    <name>RobotScreen</name>
    <message>
        <source>The robot&apos;s screen</source>
        <translation>ロボットの画面</translation>
    </message>
</context>
<context>
    <name>RobotSide</name>
    <message>
        <source>Blackboard</source>
        <translation>ブラックボード</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>実行権</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>トレース</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>しおり</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>RowWidget</name>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ</translation>
    </message>
</context>
<context>
    <name>Rows</name>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>{0} を取り除く</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>Ruler above</source>
        <translation>上の定規</translation>
    </message>
    <message>
        <source>Ruler at the left</source>
        <translation>左の定規</translation>
    </message>
    <message>
        <source>Drag from here down: a guide across the screen</source>
        <translation>ここから下へドラッグすると、画面を横切るガイドができます</translation>
    </message>
    <message>
        <source>Drag from here to the right: a guide down the screen</source>
        <translation>ここから右へドラッグすると、画面を縦に通るガイドができます</translation>
    </message>
</context>
<context>
    <name>SamplePopup</name>
    <message>
        <source>Sample values</source>
        <translation>見本の値</translation>
    </message>
    <message>
        <source>Fill texts with sample values</source>
        <translation>文字に見本の値を入れる</translation>
    </message>
    <message>
        <source>Else texts are shown as they are written</source>
        <translation>入れないときは、書いたとおりに表示されます</translation>
    </message>
    <message>
        <source>From the tags at the start and the scenarios; type another one.</source>
        <translation>最初のタグとシナリオの値です。別の値も入力できます。</translation>
    </message>
    <message>
        <source>No text of this screen refers to a value.</source>
        <translation>この画面の文字は値を使っていません。</translation>
    </message>
</context>
<context>
    <name>SampleTable</name>
    <message>
        <source>Entry</source>
        <translation>入力</translation>
    </message>
</context>
<context>
    <name>Sampling</name>
    <message>
        <source>{0} entries</source>
        <translation>{0} 件</translation>
    </message>
</context>
<context>
    <name>SavingRecording</name>
    <message>
        <source>Writing {0}</source>
        <translation>{0} を書いています</translation>
    </message>
    <message>
        <source>The robot has begun anew: nothing was saved.</source>
        <translation>ロボットがはじめからやり直しました。何も保存していません。</translation>
    </message>
    <message>
        <source>{0} is saved: {1} events.</source>
        <translation>{0} を保存しました：イベント {1} 件。</translation>
    </message>
</context>
<context>
    <name>SavingScenario</name>
    <message>
        <source>Save as a scenario</source>
        <translation>シナリオとして保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the scenario</source>
        <translation>シナリオの名前</translation>
    </message>
    <message>
        <source>What shall happen again</source>
        <translation>もう一度起こるはずのこと</translation>
    </message>
    <message>
        <source>What is expected</source>
        <translation>期待すること</translation>
    </message>
    <message>
        <source>Changes were taken in on the way. The scenario runs all of it with the project as it is then: look whether it goes well.</source>
        <translation>途中で変更を取り入れています。シナリオは、実行するときのプロジェクトで最初から通して行われます。うまくいくか確かめてください。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>A file can not be called that.</source>
        <translation>ファイルにその名前は使えません。</translation>
    </message>
    <message>
        <source>There is a scenario of that name.</source>
        <translation>その名前のシナリオはもうあります。</translation>
    </message>
</context>
<context>
    <name>ScenariosPanel</name>
    <message>
        <source>Run all</source>
        <translation>すべて実行</translation>
    </message>
    <message>
        <source>Each is done from the start, with the project as it is now</source>
        <translation>それぞれ最初から、今のプロジェクトで実行します</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>図に表示</translation>
    </message>
    <message>
        <source>How often they came through each state and transition, on the drawings</source>
        <translation>各状態と遷移を通った回数を図に表示します</translation>
    </message>
    <message>
        <source>A scenario is what people and sensors do, and what shall happen then. Run all plays those of this project. A new one is a rehearsal that is saved: press Rehearse, do what people would do, and then Save as a scenario.</source>
        <translation>シナリオは、人やセンサーがすることと、そのとき起こるべきことです。「すべて実行」はこのプロジェクトのシナリオを実行します。新しいシナリオは、リハーサルを保存したものです。「リハーサル」を押し、人がすることをしてから、シナリオとして保存してください。</translation>
    </message>
    <message>
        <source>Not run yet</source>
        <translation>未実行</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>期待</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Its file; below them, what none of them came through.</source>
        <translation>シナリオのファイル。その下に、どれも通らなかったもの。</translation>
    </message>
    <message>
        <source>Whether all that was expected happened.</source>
        <translation>期待したことがすべて起きたか。</translation>
    </message>
    <message>
        <source>How much was expected.</source>
        <translation>期待したことの数。</translation>
    </message>
    <message>
        <source>Where it failed first. A click shows that moment in all views.</source>
        <translation>最初に失敗したところ。クリックすると、どの表示もその時点になります。</translation>
    </message>
</context>
<context>
    <name>ScenariosSide</name>
    <message>
        <source>Scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Running the scenarios</source>
        <translation>シナリオを実行中</translation>
    </message>
</context>
<context>
    <name>ScreenBeside</name>
    <message>
        <source>Screen of the selected state</source>
        <translation>選んだ状態の画面</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>“{0}”</source>
        <translation>「{0}」</translation>
    </message>
</context>
<context>
    <name>ScreenPreview</name>
    <message>
        <source>Picture of the screen</source>
        <translation>画面の絵</translation>
    </message>
    <message>
        <source>keeps what was shown before</source>
        <translation>前の表示のまま</translation>
    </message>
</context>
<context>
    <name>ScriptAsking</name>
    <message>
        <source>Select data, a situation or a module</source>
        <translation>データ、状況、モジュールのどれかを選んでください</translation>
    </message>
    <message>
        <source>What does it lead to?</source>
        <translation>行き先は？</translation>
    </message>
    <message>
        <source>There is no other situation to take over from</source>
        <translation>引き継ぎ元になるほかの状況がありません</translation>
    </message>
    <message>
        <source>Take over from which?</source>
        <translation>どれから引き継ぎますか？</translation>
    </message>
    <message>
        <source>Until what?</source>
        <translation>何まで続きますか？</translation>
    </message>
    <message>
        <source>When what?</source>
        <translation>何のときですか？</translation>
    </message>
    <message>
        <source>There is no data yet: add some first</source>
        <translation>まだデータがありません。先に追加してください</translation>
    </message>
    <message>
        <source>Stays at least, in seconds</source>
        <translation>最低継続時間（秒）</translation>
    </message>
    <message>
        <source>Ends after, in seconds</source>
        <translation>終わるまでの時間（秒）</translation>
    </message>
    <message>
        <source>Write seconds above 0, or nothing, not {0}</source>
        <translation>0 より大きい秒数か、空欄にしてください。{0} は使えません</translation>
    </message>
    <message>
        <source>{0}  {1}, taken over</source>
        <translation>{0}  {1}、引き継ぎ</translation>
    </message>
    <message>
        <source>Which module&apos;s priority?</source>
        <translation>どのモジュールの優先度ですか？</translation>
    </message>
    <message>
        <source>Select data</source>
        <translation>データを選んでください</translation>
    </message>
    <message>
        <source>any value</source>
        <translation>どんな値でも</translation>
    </message>
    <message>
        <source>What kind of value?</source>
        <translation>どんな値ですか？</translation>
    </message>
    <message>
        <source>Unit, such as deg or m</source>
        <translation>単位（deg、m など）</translation>
    </message>
    <message>
        <source>Select one thing, or nothing for a note on the script</source>
        <translation>一つだけ選ぶか、スクリプト全体のメモなら何も選ばないでください</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
</context>
<context>
    <name>ScriptCanvas</name>
    <message>
        <source>No situation yet. Drag Situation, Data and Module from the palette to here, then from card to card, from left to right.</source>
        <translation>まだ状況がありません。パレットから「状況」「データ」「モジュール」をここへドラッグし、次にカードからカードへ、左から右へつないでください。</translation>
    </message>
    <message>
        <source>When shall something else go first? Press Data in the palette and name what the robot notices, then drag from its right edge to an empty place: a situation.</source>
        <translation>ほかのものを先にするのはいつですか？ パレットの「データ」を押してロボットが気づくことの名前を付け、右の端から何もないところへドラッグすると、状況ができます。</translation>
    </message>
    <message>
        <source>When what?</source>
        <translation>何のときですか？</translation>
    </message>
    <message>
        <source>Drop a condition on the situation that it is of</source>
        <translation>条件は、その状況の上に置いてください</translation>
    </message>
</context>
<context>
    <name>ScriptChoosing</name>
    <message>
        <source>Select one situation</source>
        <translation>状況を一つ選んでください</translation>
    </message>
    <message>
        <source>All of them are selected already</source>
        <translation>もうすべて選ばれています</translation>
    </message>
    <message>
        <source>Select something from which a pipe leads</source>
        <translation>線の出発点になるものを選んでください</translation>
    </message>
</context>
<context>
    <name>ScriptCommands</name>
    <message>
        <source>Select a condition</source>
        <translation>条件を選んでください</translation>
    </message>
    <message>
        <source>What shall hold?</source>
        <translation>どう成り立てばよいですか？</translation>
    </message>
    <message>
        <source>Select tests that stand beside each other in one group</source>
        <translation>同じまとまりで隣り合う判定を選んでください</translation>
    </message>
    <message>
        <source>Select a group of tests</source>
        <translation>判定のまとまりを選んでください</translation>
    </message>
    <message>
        <source>Select a priority</source>
        <translation>優先度を選んでください</translation>
    </message>
    <message>
        <source>Connect {0} cards</source>
        <translation>カード {0} 枚をつなぐ</translation>
    </message>
</context>
<context>
    <name>SectionEditor</name>
    <message>
        <source>Open the screen</source>
        <translation>画面を開く</translation>
    </message>
    <message>
        <source>Keep what was shown before</source>
        <translation>前の表示のままにする</translation>
    </message>
    <message>
        <source>Remove screen</source>
        <translation>画面を削除</translation>
    </message>
    <message>
        <source>Add a priority</source>
        <translation>優先度を加える</translation>
    </message>
    <message>
        <source>Add a {0}</source>
        <translation>{0}を加える</translation>
    </message>
    <message>
        <source>Add an event</source>
        <translation>イベントを加える</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Remove {0}</source>
        <translation>{0}を削除</translation>
    </message>
    <message>
        <source>Move {0}</source>
        <translation>{0}を移動</translation>
    </message>
    <message>
        <source>Add screen</source>
        <translation>画面を追加</translation>
    </message>
</context>
<context>
    <name>SettingDialog</name>
    <message>
        <source>Set a value</source>
        <translation>値を設定</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>nothing: removes it</source>
        <translation>空欄: 削除します</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>It is {0} now.</source>
        <translation>現在は {0} です。</translation>
    </message>
    <message>
        <source>It is not set now.</source>
        <translation>現在は設定されていません。</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Tab goes from component to component, arrows move one, F2 writes its text.</source>
        <translation>Tab で次の部品へ、矢印で移動、F2 で文字を書きます。</translation>
    </message>
    <message>
        <source>Align {0}</source>
        <translation>{0} を揃える</translation>
    </message>
</context>
<context>
    <name>Shortcuts</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
</context>
<context>
    <name>Sides</name>
    <message>
        <source>Priorities</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Who holds it when all ask</source>
        <translation>全員が要求したときに使うもの</translation>
    </message>
    <message>
        <source>There is no situation yet: add one.</source>
        <translation>まだ状況がありません。追加してください。</translation>
    </message>
    <message>
        <source>There is no module yet: add one.</source>
        <translation>まだモジュールがありません。追加してください。</translation>
    </message>
</context>
<context>
    <name>SituationCommands</name>
    <message>
        <source>Add a script of situations</source>
        <translation>状況のスクリプトを追加</translation>
    </message>
</context>
<context>
    <name>Sounding</name>
    <message>
        <source>espeak-ng is not installed on this computer, so the robot is not heard.</source>
        <translation>このコンピューターに espeak-ng がないため、ロボットの声は聞こえません。</translation>
    </message>
</context>
<context>
    <name>SpeechBubble</name>
    <message>
        <source>What the robot says</source>
        <translation>ロボットの発話</translation>
    </message>
    <message>
        <source>How long it still says that</source>
        <translation>あとどれだけ話すか</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音声</translation>
    </message>
    <message>
        <source>Hear what the robot says, at 1 ×</source>
        <translation>ロボットの発話を聞く（1 × のとき）</translation>
    </message>
    <message>
        <source>The robot says nothing</source>
        <translation>ロボットは何も話していません</translation>
    </message>
    <message>
        <source>{0:.1f} s left</source>
        <translation>残り {0:.1f} 秒</translation>
    </message>
    <message>
        <source>The robot says {0}</source>
        <translation>ロボットの言葉: {0}</translation>
    </message>
</context>
<context>
    <name>StateCommands</name>
    <message>
        <source>A timeout has no guard: give it no target, and guard the event timeout.</source>
        <translation>時間切れには条件を付けられません。行き先をなくし、イベント timeout に条件を付けてください。</translation>
    </message>
    <message>
        <source>This leads nowhere: the state stays.</source>
        <translation>行き先はありません。状態はそのままです。</translation>
    </message>
    <message>
        <source>This leads to another state each time.</source>
        <translation>行き先は毎回変わります。</translation>
    </message>
    <message>
        <source>There is no state {0}.</source>
        <translation>状態 {0} はありません。</translation>
    </message>
</context>
<context>
    <name>StateScreen</name>
    <message>
        <source>{0} shows its own screens.</source>
        <translation>{0} はそれ自身の画面を出します。</translation>
    </message>
    <message>
        <source>Drag a component here, or press one of them.</source>
        <translation>画面の部品をここにドラッグするか、どれかを押してください。</translation>
    </message>
    <message>
        <source>This state keeps what was shown before.</source>
        <translation>この状態は前の画面をそのまま出します。</translation>
    </message>
</context>
<context>
    <name>StateStrip</name>
    <message>
        <source>States</source>
        <translation>状態</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>no robot</source>
        <translation>ロボットなし</translation>
    </message>
    <message>
        <source>“In every state” selected</source>
        <translation>「すべての状態」を選択中</translation>
    </message>
    <message>
        <source>{0} selected</source>
        <translation>{0}を選択中</translation>
    </message>
    <message>
        <source>{0} error</source>
        <translation>エラー {0} 件</translation>
    </message>
    <message>
        <source>{0} errors</source>
        <translation>エラー {0} 件</translation>
    </message>
    <message>
        <source>{0} warning</source>
        <translation>警告 {0} 件</translation>
    </message>
    <message>
        <source>{0} warnings</source>
        <translation>警告 {0} 件</translation>
    </message>
    <message>
        <source>{0} state</source>
        <translation>状態 {0} 個</translation>
    </message>
    <message>
        <source>{0} states</source>
        <translation>状態 {0} 個</translation>
    </message>
    <message>
        <source>{0} event</source>
        <translation>イベント {0} 個</translation>
    </message>
    <message>
        <source>{0} events</source>
        <translation>イベント {0} 個</translation>
    </message>
    <message>
        <source>{0} action</source>
        <translation>動作 {0} 件</translation>
    </message>
    <message>
        <source>{0} actions</source>
        <translation>動作 {0} 件</translation>
    </message>
    <message>
        <source>{0} screen</source>
        <translation>画面 {0} 件</translation>
    </message>
    <message>
        <source>{0} screens</source>
        <translation>画面 {0} 件</translation>
    </message>
    <message>
        <source>{0} component</source>
        <translation>部品 {0} 件</translation>
    </message>
    <message>
        <source>{0} components</source>
        <translation>画面の部品 {0} 個</translation>
    </message>
    <message>
        <source>{0} timeout</source>
        <translation>時間切れ {0} 個</translation>
    </message>
    <message>
        <source>{0} timeouts</source>
        <translation>時間切れ {0} 個</translation>
    </message>
    <message>
        <source>{0} situation</source>
        <translation>状況 {0} 個</translation>
    </message>
    <message>
        <source>{0} situations</source>
        <translation>状況 {0} 個</translation>
    </message>
    <message>
        <source>{0} module</source>
        <translation>モジュール {0} 個</translation>
    </message>
    <message>
        <source>{0} modules</source>
        <translation>モジュール {0} 個</translation>
    </message>
    <message>
        <source>{0} priority</source>
        <translation>優先度 {0} 個</translation>
    </message>
    <message>
        <source>{0} priorities</source>
        <translation>優先度 {0} 個</translation>
    </message>
    <message>
        <source>{0} data</source>
        <translation>データ {0} 個</translation>
    </message>
    <message>
        <source>{0} resource</source>
        <translation>リソース {0} 個</translation>
    </message>
    <message>
        <source>{0} resources</source>
        <translation>リソース {0} 個</translation>
    </message>
    <message>
        <source>{0} note</source>
        <translation>メモ {0} 個</translation>
    </message>
    <message>
        <source>{0} notes</source>
        <translation>メモ {0} 個</translation>
    </message>
    <message>
        <source>{0} frame</source>
        <translation>枠 {0} 個</translation>
    </message>
    <message>
        <source>{0} frames</source>
        <translation>枠 {0} 個</translation>
    </message>
    <message>
        <source>{0} thing</source>
        <translation>{0} 個</translation>
    </message>
    <message>
        <source>{0} things</source>
        <translation>{0} 個</translation>
    </message>
    <message>
        <source>{0} transition</source>
        <translation>遷移 {0} 個</translation>
    </message>
    <message>
        <source>{0} transitions</source>
        <translation>遷移 {0} 個</translation>
    </message>
    <message>
        <source>{0} document not saved</source>
        <translation>保存していない文書 {0} 個</translation>
    </message>
    <message>
        <source>{0} documents not saved</source>
        <translation>保存していない文書 {0} 個</translation>
    </message>
    <message>
        <source>Saved {0}</source>
        <translation>{0} に保存</translation>
    </message>
    <message>
        <source>No changes</source>
        <translation>変更なし</translation>
    </message>
</context>
<context>
    <name>TagChip</name>
    <message>
        <source>Drag it into a text, or press it to put it at its end</source>
        <translation>文字へドラッグするか、押すと文字の終わりに入ります</translation>
    </message>
</context>
<context>
    <name>TagChips</name>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>None yet: write {name} in a text</source>
        <translation>まだありません。文の中に {name} のように書いてください</translation>
    </message>
</context>
<context>
    <name>TakingNotice</name>
    <message>
        <source>How it is with your changes</source>
        <translation>変更の状態</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>取り入れる</translation>
    </message>
    <message>
        <source>It goes on with your changes, from the next moment at which no action runs</source>
        <translation>次に動作が何もなくなったときから、変更した内容で続けます</translation>
    </message>
    <message>
        <source>At once</source>
        <translation>すぐに</translation>
    </message>
    <message>
        <source>What runs now is broken off if it is another now</source>
        <translation>今の動作は、変更されていれば途中でやめます</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>It goes on as before your changes, at once</source>
        <translation>すぐに、変更する前の内容で続けます</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>もう一度始める</translation>
    </message>
    <message>
        <source>From the start, with your changes</source>
        <translation>変更した内容で最初から始めます</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>しばらく</translation>
    </message>
    <message>
        <source>Your changes wait until no action runs: {0}.</source>
        <translation>動作がなくなるのを待って変更を取り入れます：{0}</translation>
    </message>
    <message>
        <source>With your changes it went wrong, and what ran before runs again: {0}</source>
        <translation>変更した内容で問題が起きたため、前の内容に戻りました：{0}</translation>
    </message>
    <message>
        <source>The project has changed since.</source>
        <translation>その後プロジェクトが変わりました。</translation>
    </message>
    <message>
        <source>It goes on with your changes.</source>
        <translation>変更した内容で続いています。</translation>
    </message>
</context>
<context>
    <name>TellingSide</name>
    <message>
        <source>Taken back: {0}</source>
        <translation>元に戻しました: {0}</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>{0}, and {1} more</source>
        <translation>{0}、ほか {1} 件</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>問題はありません。</translation>
    </message>
    <message>
        <source>Still {0}</source>
        <translation>まだ {0}</translation>
    </message>
    <message>
        <source>{0} error</source>
        <translation>エラー {0} 件</translation>
    </message>
    <message>
        <source>{0} errors</source>
        <translation>エラー {0} 件</translation>
    </message>
    <message>
        <source>{0} warning</source>
        <translation>警告 {0} 件</translation>
    </message>
    <message>
        <source>{0} warnings</source>
        <translation>警告 {0} 件</translation>
    </message>
</context>
<context>
    <name>TemplateTile</name>
    <message>
        <source>Template: {0}</source>
        <translation>ひな形：{0}</translation>
    </message>
    <message>
        <source>The state gets this screen; undo brings back the one before</source>
        <translation>状態の画面をこれにします。「元に戻す」で前の画面に戻せます</translation>
    </message>
    <message>
        <source>Remove this template</source>
        <translation>このひな形を取り除く</translation>
    </message>
</context>
<context>
    <name>TestBox</name>
    <message>
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Remove this test</source>
        <translation>この条件を削除</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>比べ方</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>within</source>
        <translation>以内</translation>
    </message>
    <message>
        <source>for</source>
        <translation>継続</translation>
    </message>
    <message>
        <source>Test of {0}</source>
        <translation>{0} の条件</translation>
    </message>
</context>
<context>
    <name>TestEditor</name>
    <message>
        <source>Test</source>
        <translation>判定</translation>
    </message>
</context>
<context>
    <name>TextsModel</name>
    <message>
        <source>Phrase for {0}</source>
        <translation>{0} の言葉</translation>
    </message>
    <message>
        <source>Speech</source>
        <translation>発話</translation>
    </message>
    <message>
        <source>The state, or the setting, in which the text stands.</source>
        <translation>この文がある状態、または設定です。</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Text as written</source>
        <translation>書かれた文字</translation>
    </message>
    <message>
        <source>{0}, {1} of {2}</source>
        <translation>{0}、{2} 件中 {1} 件</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>What says it or shows it there.</source>
        <translation>それを話すか見せるもの。</translation>
    </message>
    <message>
        <source>As it is written in the documents: what you type here goes there.</source>
        <translation>文書に書かれたままの文字。ここで入力すると文書が変わります。</translation>
    </message>
    <message>
        <source>{0} of {1} texts translated</source>
        <translation>{1} 件中 {0} 件を翻訳済み</translation>
    </message>
    <message>
        <source>{0} missing</source>
        <translation>未翻訳 {0} 件</translation>
    </message>
    <message>
        <source>{0} to be looked at</source>
        <translation>要確認 {0} 件</translation>
    </message>
    <message>
        <source>{0} without a tag of the text</source>
        <translation>タグ抜け {0} 件</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>always said in {0}</source>
        <translation>いつも {0} で話す</translation>
    </message>
    <message>
        <source>nothing to translate</source>
        <translation>翻訳するものなし</translation>
    </message>
    <message>
        <source>to be looked at: it was “{0}”</source>
        <translation>要確認：前は「{0}」</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>要確認</translation>
    </message>
    <message>
        <source>leaves out {0}</source>
        <translation>{0} が抜けています</translation>
    </message>
</context>
<context>
    <name>TextsPage</name>
    <message>
        <source>No text fits what you look for.</source>
        <translation>探しているものに合う文字がありません。</translation>
    </message>
    <message>
        <source>Find a text</source>
        <translation>文字を検索</translation>
    </message>
    <message>
        <source>Only texts with these letters, in any language.</source>
        <translation>どの言語でも、この文字を含むものだけ。</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>見せる</translation>
    </message>
    <message>
        <source>Spoken</source>
        <translation>話す</translation>
    </message>
    <message>
        <source>Heard</source>
        <translation>聞き取る</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Which texts</source>
        <translation>どの文字</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>Only what is missing, has to be looked at, or leaves out a {tag}.</source>
        <translation>未翻訳、要確認、{tag} の抜けたものだけ。</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>聞く</translation>
    </message>
    <message>
        <source>It is right</source>
        <translation>これでよい</translation>
    </message>
    <message>
        <source>Import translations…</source>
        <translation>翻訳を読み込む…</translation>
    </message>
    <message>
        <source>Export for a translator…</source>
        <translation>翻訳者用に書き出す…</translation>
    </message>
    <message>
        <source>Add a language…</source>
        <translation>言語を追加…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>{0} texts</source>
        <translation>文字 {0} 件</translation>
    </message>
    <message>
        <source>{0} of {1} texts</source>
        <translation>文字 {1} 件中 {0} 件</translation>
    </message>
    <message>
        <source>one language only: add another to translate them</source>
        <translation>言語は一つだけです。翻訳するには追加してください</translation>
    </message>
    <message>
        <source>Change {0} texts</source>
        <translation>文字 {0} 件を変更</translation>
    </message>
    <message>
        <source>Change the text “{0}”</source>
        <translation>文字「{0}」を変更</translation>
    </message>
    <message>
        <source>Translate “{0}” into {1}</source>
        <translation>「{0}」を {1} に翻訳</translation>
    </message>
    <message>
        <source>Show where it stands</source>
        <translation>置いてある場所を表示</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
</context>
<context>
    <name>TextsTable</name>
    <message>
        <source>Texts</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>{0} cells had no room in the table and were left out.</source>
        <translation>表に入らないセル {0} 個は省きました。</translation>
    </message>
</context>
<context>
    <name>TimeoutRows</name>
    <message>
        <source>Timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>then to</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>The timeout leads to</source>
        <translation>時間切れの行き先</translation>
    </message>
    <message>
        <source>only when idle</source>
        <translation>操作のない間だけ</translation>
    </message>
    <message>
        <source>raises the event timeout</source>
        <translation>イベント timeout を起こす</translation>
    </message>
    <message>
        <source>the same state, anew</source>
        <translation>同じ状態をもう一度</translation>
    </message>
    <message>
        <source>back to where it came from</source>
        <translation>元の状態に戻る</translation>
    </message>
</context>
<context>
    <name>TitleBar</name>
    <message>
        <source>Dock again</source>
        <translation>元の場所に戻す</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>切り離す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>Told</name>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>TutorialWindow</name>
    <message>
        <source>Tutorial</source>
        <translation>チュートリアル</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>前のステップ</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次のステップ</translation>
    </message>
    <message>
        <source>What is to be done then</source>
        <translation>そのときにすること</translation>
    </message>
    <message>
        <source>Step {0} of {1}</source>
        <translation>ステップ {0}／{1}</translation>
    </message>
    <message>
        <source>{0} steps</source>
        <translation>全 {0} ステップ</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>始める</translation>
    </message>
</context>
<context>
    <name>Twin</name>
    <message>
        <source>Outline of the document</source>
        <translation>文書のアウトライン</translation>
    </message>
    <message>
        <source>Delete {0}</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>Delete {0} things</source>
        <translation>{0} 件を削除</translation>
    </message>
    <message>
        <source>Move {0}</source>
        <translation>{0}を移動</translation>
    </message>
    <message>
        <source>Add state {0}</source>
        <translation>状態 {0} を追加</translation>
    </message>
    <message>
        <source>This can not be left empty.</source>
        <translation>空にはできません。</translation>
    </message>
</context>
<context>
    <name>TwinDelegate</name>
    <message>
        <source>nothing, it stays</source>
        <translation>なし（そのまま）</translation>
    </message>
    <message>
        <source>the same state, anew</source>
        <translation>同じ状態をもう一度</translation>
    </message>
    <message>
        <source>back to where it came from</source>
        <translation>元の状態に戻る</translation>
    </message>
</context>
<context>
    <name>TwinModel</name>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Leads to</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Takes over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Resources</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>What else it says, in short.</source>
        <translation>そのほかの内容を短く。</translation>
    </message>
    <message>
        <source>What it is called.</source>
        <translation>呼び名。</translation>
    </message>
    <message>
        <source>The state to which it leads.</source>
        <translation>行き先の状態。</translation>
    </message>
    <message>
        <source>The state&apos;s number, or what stands in it.</source>
        <translation>状態の番号、またはその中にあるもの。</translation>
    </message>
    <message>
        <source>What of the script it is.</source>
        <translation>スクリプトの何か。</translation>
    </message>
    <message>
        <source>The situation whose priorities it takes over.</source>
        <translation>優先度を引き継ぐ元の状況。</translation>
    </message>
    <message>
        <source>The parts of the robot that it moves.</source>
        <translation>動かすロボットの部分。</translation>
    </message>
</context>
<context>
    <name>Value</name>
    <message>
        <source>Write a number.</source>
        <translation>数値を書いてください。</translation>
    </message>
</context>
<context>
    <name>ValueField</name>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>はい・いいえ</translation>
    </message>
    <message>
        <source>List</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>What sort of value it is.</source>
        <translation>値の種類。</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Welcome</source>
        <translation>ようこそ</translation>
    </message>
    <message>
        <source>Tutorial, a quarter of an hour</source>
        <translation>チュートリアル（15 分）</translation>
    </message>
    <message>
        <source>A first robot from nothing, one step at a time</source>
        <translation>最初のロボットを何もないところから、一歩ずつ</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>はじめに</translation>
    </message>
    <message>
        <source>What a project is, and how one begins; F1 explains the rest</source>
        <translation>プロジェクトとは何か、どう始めるか。ほかは F1 が説明します</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Welcome to Situ Studio</source>
        <translation>Situ Studio へようこそ</translation>
    </message>
    <message>
        <source>Draw what a robot says, shows and does, and watch it live.</source>
        <translation>ロボットが話し、見せ、行うことを描き、その動きを見守ります。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>始める</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>新しいプロジェクト</translation>
    </message>
    <message>
        <source>An empty one to start from</source>
        <translation>空の状態から始めます</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>A folder with situ.toml</source>
        <translation>situ.toml のあるフォルダー</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>ロボットに接続</translation>
    </message>
    <message>
        <source>Found nearby, or by its address</source>
        <translation>近くで見つけるか、アドレスを指定</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近のプロジェクト</translation>
    </message>
    <message>
        <source>Open an example</source>
        <translation>例を開く</translation>
    </message>
    <message>
        <source>a copy is made, so try anything</source>
        <translation>コピーが作られるので、自由に試せます</translation>
    </message>
    <message>
        <source>New from a template</source>
        <translation>ひな形から作る</translation>
    </message>
    <message>
        <source>Question and answers</source>
        <translation>質問と答え</translation>
    </message>
    <message>
        <source>Ask, wait, thank</source>
        <translation>たずねて、待って、お礼</translation>
    </message>
    <message>
        <source>Main menu</source>
        <translation>メインメニュー</translation>
    </message>
    <message>
        <source>Services to choose from</source>
        <translation>サービスを選ぶ画面</translation>
    </message>
    <message>
        <source>Medication reminder</source>
        <translation>薬のお知らせ</translation>
    </message>
    <message>
        <source>Once a day, else a nurse</source>
        <translation>一日一度、または看護師へ</translation>
    </message>
    <message>
        <source>Modules that share a robot</source>
        <translation>ロボットの分け合い</translation>
    </message>
    <message>
        <source>Situations, priorities, a stop</source>
        <translation>状況、優先度、停止</translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation>{0} に戻る</translation>
    </message>
    <message>
        <source>It is still open</source>
        <translation>まだ開いています</translation>
    </message>
</context>
<context>
    <name>WhatIf</name>
    <message>
        <source>Modules that ask</source>
        <translation>要求するモジュール</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>もしも</translation>
    </message>
    <message>
        <source>Suppose values: each counts as set just now, and as having lasted long enough. What keeps a situation for a while is not counted. Nothing of this is saved.
A right click or the down key gives other values.</source>
        <translation>値を仮定します。どれも今書き込まれ、十分に続いたものとみなします。状況をしばらく保つ設定は考えません。何も保存されません。
右クリックか下矢印キーで別の値を選べます。</translation>
    </message>
    <message>
        <source>Supposed values</source>
        <translation>仮定した値</translation>
    </message>
    <message>
        <source>no situation looks at data yet</source>
        <translation>まだどの状況もデータを見ていません</translation>
    </message>
    <message>
        <source>Suppose nothing</source>
        <translation>何も仮定しない</translation>
    </message>
    <message>
        <source>another value</source>
        <translation>別の値</translation>
    </message>
    <message>
        <source>Another value of {0}</source>
        <translation>{0} の別の値</translation>
    </message>
    <message>
        <source>{0} of {1} ask</source>
        <translation>{1} のうち {0} が要求</translation>
    </message>
    <message>
        <source>all ask</source>
        <translation>全員が要求</translation>
    </message>
    <message>
        <source>Which modules ask for what they can use</source>
        <translation>使えるものを要求するモジュール</translation>
    </message>
    <message>
        <source>no situation</source>
        <translation>状況なし</translation>
    </message>
</context>
<context>
    <name>WhenTouched</name>
    <message>
        <source>The state expects it</source>
        <translation>状態が待っています</translation>
    </message>
    <message>
        <source>All right</source>
        <translation>問題なし</translation>
    </message>
    <message>
        <source>The state does not expect {0}: nothing happens.</source>
        <translation>状態は {0} を待っていません。何も起こりません。</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Expect {0}</source>
        <translation>{0} を待つ</translation>
    </message>
    <message>
        <source>The state gets this event; say then where it leads</source>
        <translation>状態にこのイベントを加えます。次に行き先を決めてください</translation>
    </message>
    <message>
        <source>{0} leads to {1}</source>
        <translation>{0} の行き先は {1}</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>そこへ行く</translation>
    </message>
    <message>
        <source>Show the event</source>
        <translation>イベントを表示</translation>
    </message>
    <message>
        <source>Expect {0} in {1}</source>
        <translation>{1} で {0} を待つ</translation>
    </message>
</context>
<context>
    <name>WhyMenus</name>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>なぜ？</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>ほかの人</translation>
    </message>
    <message>
        <source>Why did {0} move?</source>
        <translation>{0} はなぜ動いた？</translation>
    </message>
    <message>
        <source>Why is {0} held so?</source>
        <translation>{0} はなぜこう使われている？</translation>
    </message>
    <message>
        <source>Why not {0}?</source>
        <translation>なぜ {0} ではない？</translation>
    </message>
    <message>
        <source>Why is {0} not the situation?</source>
        <translation>なぜ状況が {0} でない？</translation>
    </message>
    <message>
        <source>the timeout</source>
        <translation>時間切れ</translation>
    </message>
</context>
<context>
    <name>WhySide</name>
    <message>
        <source>Why?</source>
        <translation>なぜ？</translation>
    </message>
    <message>
        <source>A trace tells nothing of that.</source>
        <translation>記録からは分かりません。</translation>
    </message>
    <message>
        <source>What ran had no {0}.</source>
        <translation>動いていたものに {0} はありませんでした。</translation>
    </message>
    <message>
        <source>What ran had nothing of that in {0}.</source>
        <translation>動いていたものの {0} には、それがありませんでした。</translation>
    </message>
    <message>
        <source>Select a state, a transition, a situation, a module or a resource.</source>
        <translation>状態、遷移、状況、モジュール、リソースのどれかを選んでください。</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>調べています…</translation>
    </message>
    <message>
        <source>It has not happened up to this moment.</source>
        <translation>この時点までには起きていません。</translation>
    </message>
    <message>
        <source>Nothing of it is in what is kept of the trace.</source>
        <translation>残っている記録の中にはありません。</translation>
    </message>
    <message>
        <source>at {0}</source>
        <translation>{0} に</translation>
    </message>
    <message>
        <source>{0}, {1} s after what began it</source>
        <translation>{0}、きっかけの {1} 秒後</translation>
    </message>
    <message>
        <source>{0}; {1} ago</source>
        <translation>{0}（{1} 前）</translation>
    </message>
    <message>
        <source>{0} ({1})</source>
        <translation>{0}（{1}）</translation>
    </message>
    <message>
        <source>{0} not set</source>
        <translation>{0} は未設定</translation>
    </message>
    <message>
        <source>{0} has priority {1}</source>
        <translation>{0} の優先度は {1}</translation>
    </message>
    <message>
        <source>{0} has no priority</source>
        <translation>{0} に優先度はありません</translation>
    </message>
    <message>
        <source>There is no answer.</source>
        <translation>答えがありません。</translation>
    </message>
    <message>
        <source>The log says what went wrong.</source>
        <translation>何が起きたかはログにあります。</translation>
    </message>
    <message>
        <source>{0}: it was so already</source>
        <translation>{0}：もうそうなっていました</translation>
    </message>
    <message>
        <source>{0}; by the documents that ran, not those open here</source>
        <translation>{0}。ここで開いているものではなく、動いていた書類によります</translation>
    </message>
    <message>
        <source>{0}; by the documents open here: those that ran are not known</source>
        <translation>{0}。動いていた書類が分からないので、ここで開いているものによります</translation>
    </message>
    <message>
        <source>{0} is not open here: only what ran has it.</source>
        <translation>{0} はここでは開いていません。動いていたものにだけあります。</translation>
    </message>
    <message>
        <source>Only what ran has that: {0} here has not.</source>
        <translation>それは動いていたものにだけあり、ここの {0} にはありません。</translation>
    </message>
    <message>
        <source>Why is {0} not in {1}?</source>
        <translation>{0} はなぜ {1} にいない？</translation>
    </message>
    <message>
        <source>Why does {0} not leave {1} by itself?</source>
        <translation>{0} はなぜ自分で {1} を出ない？</translation>
    </message>
    <message>
        <source>Why does {0} not leave {1} by {2}?</source>
        <translation>{0} はなぜ {2} で {1} を出ない？</translation>
    </message>
    <message>
        <source>Why is {0} not the situation?</source>
        <translation>なぜ状況が {0} でない？</translation>
    </message>
    <message>
        <source>Why does {0} not hold {1}?</source>
        <translation>{0} はなぜ {1} を使えない？</translation>
    </message>
    <message>
        <source>Why does {0} not move {1}?</source>
        <translation>{0} はなぜ {1} を動かさない？</translation>
    </message>
    <message>
        <source>Why does {0} not begin {1}?</source>
        <translation>{0} はなぜ {1} を始めない？</translation>
    </message>
    <message>
        <source>Why does {0} not come to {1}?</source>
        <translation>{0} はなぜ {1} に来ない？</translation>
    </message>
</context>
<context>
    <name>Windows</name>
    <message>
        <source>A fault in Situ Studio</source>
        <translation>Situ Studio の不具合</translation>
    </message>
    <message>
        <source>This Situ Studio writes no log.</source>
        <translation>この Situ Studio はログを書いていません。</translation>
    </message>
    <message>
        <source>What Situ Studio noted lately, for a report. It names files, and no texts of yours. All of it lies in {0}.</source>
        <translation>報告のための最近の記録です。ファイル名は含まれますが、あなたの文章は含まれません。全体は {0} にあります。</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Not there any more: {0}</source>
        <translation>もうありません：{0}</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Text of {0} {1}</source>
        <translation>{1}（{0}）の文字</translation>
    </message>
</context>
<context>
    <name>WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>_Amount</name>
    <message>
        <source>Write a number.</source>
        <translation>数値を書いてください。</translation>
    </message>
</context>
<context>
    <name>_Choices</name>
    <message>
        <source>Two or more, each once, with commas between.</source>
        <translation>二つ以上を、重複なくコンマで区切ってください。</translation>
    </message>
</context>
<context>
    <name>_Header</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>_Json</name>
    <message>
        <source>Write a list such as [&quot;a&quot;, &quot;b&quot;], or {&quot;a&quot;: 1}.</source>
        <translation>[&quot;a&quot;, &quot;b&quot;] や {&quot;a&quot;: 1} のように書いてください。</translation>
    </message>
    <message>
        <source>There is no null at the start: leave it out.</source>
        <translation>最初の値に null は使えません。省いてください。</translation>
    </message>
</context>
<context>
    <name>_States</name>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
</context>
<context>
    <name>actions</name>
    <message>
        <source>A few words for those who draw; the robot does not see them.</source>
        <translation>描く人のための覚え書き。ロボットには見えません。</translation>
    </message>
    <message>
        <source>A program that moves the robot when it has the authority.</source>
        <translation>実行権を持つときにロボットを動かすプログラム。</translation>
    </message>
    <message>
        <source>A state that runs another application until that ends.</source>
        <translation>別のアプリケーションを、終わるまで動かす状態。</translation>
    </message>
    <message>
        <source>A value on the blackboard that situations look at.</source>
        <translation>状況が見る、ブラックボード上の値。</translation>
    </message>
    <message>
        <source>About Situ Studio</source>
        <translation>Situ Studio について</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>実際の大きさ</translation>
    </message>
    <message>
        <source>Add to</source>
        <translation>足す</translation>
    </message>
    <message>
        <source>Adds a number to the number at a tag; a missing one counts 0.</source>
        <translation>タグの数に数を足します。なければ 0 とみなします。</translation>
    </message>
    <message>
        <source>Another name for the file of an application, script or module information, and for all in the project that refers to it.</source>
        <translation>アプリケーション、スクリプト、モジュール情報のファイルの名前と、プロジェクトの中でそれを参照しているものすべてを変えます。</translation>
    </message>
    <message>
        <source>Append</source>
        <translation>末尾に加える</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Arrange by itself</source>
        <translation>自動配置</translation>
    </message>
    <message>
        <source>Asks a web service, a module or a file, and keeps the answer.</source>
        <translation>ウェブサービス、モジュール、ファイルに尋ね、答えを保持します。</translation>
    </message>
    <message>
        <source>Back out of the part</source>
        <translation>部品から出る</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>ボタン</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Close tab</source>
        <translation>タブを閉じる</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete file…</source>
        <translation>ファイルを削除…</translation>
    </message>
    <message>
        <source>Delete the file of the row</source>
        <translation>行のファイルを削除</translation>
    </message>
    <message>
        <source>Deletes the tags that fit a pattern: user.** is everything below user.</source>
        <translation>パターンに合うタグを消します。user.** は user の下すべてです。</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Find anything, run a command…</source>
        <translation>検索、コマンドの実行…</translation>
    </message>
    <message>
        <source>A field that people type into; what they type goes to a tag.</source>
        <translation>人が入力する欄。入力はタグに入ります。</translation>
    </message>
    <message>
        <source>A film of the media folder, played once.</source>
        <translation>メディアフォルダーの動画。一度再生します。</translation>
    </message>
    <message>
        <source>A letter</source>
        <translation>文字キー</translation>
    </message>
    <message>
        <source>A letter or number</source>
        <translation>文字か数字</translation>
    </message>
    <message>
        <source>A new transition of the selected state, another target of the selected one; or what selected data, a situation or a module leads to.</source>
        <translation>選んだ状態の新しい遷移、選んだ遷移の別の行き先、または選んだデータ・状況・モジュールの行き先。</translation>
    </message>
    <message>
        <source>A picture of the media folder.</source>
        <translation>メディアフォルダーの絵。</translation>
    </message>
    <message>
        <source>A value on the robot&apos;s blackboard.</source>
        <translation>ロボットのブラックボードの値。</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>110 %</source>
        <translation>110 %</translation>
    </message>
    <message>
        <source>125 %</source>
        <translation>125 %</translation>
    </message>
    <message>
        <source>150 %</source>
        <translation>150 %</translation>
    </message>
    <message>
        <source>80 %</source>
        <translation>80 %</translation>
    </message>
    <message>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <source>A first robot in a quarter of an hour, from nothing, one step at a time.</source>
        <translation>最初のロボットを 15 分で、何もないところから一歩ずつ作ります。</translation>
    </message>
    <message>
        <source>A line across the screens of this application, which edges are drawn to; arrows move it.</source>
        <translation>このアプリケーションの画面を横切る線です。部品の端が引き寄せられ、矢印キーで動きます。</translation>
    </message>
    <message>
        <source>A line down the screens of this application, which edges are drawn to; arrows move it.</source>
        <translation>このアプリケーションの画面を縦に通る線です。部品の端が引き寄せられ、矢印キーで動きます。</translation>
    </message>
    <message>
        <source>Adds that to which the selected leads.</source>
        <translation>選んだものから続くものも選びます。</translation>
    </message>
    <message>
        <source>Adds what leads to the selected.</source>
        <translation>選んだものへ至るものも選びます。</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>揃える</translation>
    </message>
    <message>
        <source>All of these</source>
        <translation>すべて成り立つ</translation>
    </message>
    <message>
        <source>All texts</source>
        <translation>すべての文字</translation>
    </message>
    <message>
        <source>Along one axis; resize in proportion</source>
        <translation>一方向だけに動かす・縦横比を保って大きさを変える</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>ドラッグ中に Alt</translation>
    </message>
    <message>
        <source>Alt+arrows, Ctrl+arrows</source>
        <translation>Alt+矢印、Ctrl+矢印</translation>
    </message>
    <message>
        <source>Alt+click</source>
        <translation>Alt+クリック</translation>
    </message>
    <message>
        <source>An event, tag or module gets another name in every document of the project.</source>
        <translation>イベント、タグ、モジュールの名前を、プロジェクトのすべての文書で変えます。</translation>
    </message>
    <message>
        <source>Another application that begins like this one.</source>
        <translation>これと同じところから始める、もう一つのアプリケーション。</translation>
    </message>
    <message>
        <source>Another run stands below this one in the timeline, and where they part is marked.</source>
        <translation>タイムラインで別の実行を下に並べ、分かれるところに印を付けます。</translation>
    </message>
    <message>
        <source>Any of these</source>
        <translation>いずれか成り立つ</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>矢印</translation>
    </message>
    <message>
        <source>Arrows, Del on a guide</source>
        <translation>ガイドの上で矢印キー、Del</translation>
    </message>
    <message>
        <source>As if it had happened: the one of the selected transition, or any other.</source>
        <translation>起きたことにします。選んだ遷移のイベントか、ほかのどれでも。</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>Breakpoint here, or none</source>
        <translation>ここにブレークポイント・なし</translation>
    </message>
    <message>
        <source>Breakpoint with a condition</source>
        <translation>条件付きのブレークポイント</translation>
    </message>
    <message>
        <source>Bring forward</source>
        <translation>前面へ</translation>
    </message>
    <message>
        <source>Bring to the front</source>
        <translation>最前面へ</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>Clear the cells</source>
        <translation>セルを消去</translation>
    </message>
    <message>
        <source>Close the recording</source>
        <translation>記録を閉じる</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>ウィンドウを閉じる</translation>
    </message>
    <message>
        <source>Compare with a recording…</source>
        <translation>記録と比べる…</translation>
    </message>
    <message>
        <source>Connect one after the other</source>
        <translation>順につなぐ</translation>
    </message>
    <message>
        <source>Count recordings…</source>
        <translation>記録を数える…</translation>
    </message>
    <message>
        <source>Ctrl and wheel</source>
        <translation>Ctrl とホイール</translation>
    </message>
    <message>
        <source>Ctrl+A</source>
        <translation>Ctrl+A</translation>
    </message>
    <message>
        <source>Ctrl+arrows</source>
        <translation>Ctrl+矢印</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Delete the selected components</source>
        <translation>選んだ画面の部品を削除</translation>
    </message>
    <message>
        <source>Deploy…</source>
        <translation>配備…</translation>
    </message>
    <message>
        <source>Dissolve the part</source>
        <translation>部品を解く</translation>
    </message>
    <message>
        <source>Document before</source>
        <translation>前の文書</translation>
    </message>
    <message>
        <source>Draw the folded pipe, or fold it</source>
        <translation>畳んだ線を描く・線を畳む</translation>
    </message>
    <message>
        <source>Duplicate application</source>
        <translation>アプリケーションを複製</translation>
    </message>
    <message>
        <source>Each is done from the start, and what shall happen is looked for.</source>
        <translation>それぞれ最初から実行し、期待したことが起きるか調べます。</translation>
    </message>
    <message>
        <source>End after…</source>
        <translation>期限…</translation>
    </message>
    <message>
        <source>End the rehearsal</source>
        <translation>リハーサルを終える</translation>
    </message>
    <message>
        <source>English</source>
        <translation>English</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Evenly one above the other</source>
        <translation>縦に等間隔</translation>
    </message>
    <message>
        <source>Evenly side by side</source>
        <translation>横に等間隔</translation>
    </message>
    <message>
        <source>Every panel back to where it lies at first</source>
        <translation>すべてのパネルを最初の位置に戻します</translation>
    </message>
    <message>
        <source>Every place that mentions the selected event, tag, state, module or file.</source>
        <translation>選んだイベント、タグ、状態、モジュール、ファイルを使うすべての箇所。</translation>
    </message>
    <message>
        <source>Every text of the project, spoken, shown and heard, with a column a language</source>
        <translation>話す・見せる・聞き取る文字のすべてを、言語ごとの列で</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Export for a robot…</source>
        <translation>ロボット用に書き出す…</translation>
    </message>
    <message>
        <source>Export picture…</source>
        <translation>画像を書き出す…</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>下へ埋める</translation>
    </message>
    <message>
        <source>Fill to the right</source>
        <translation>右へ埋める</translation>
    </message>
    <message>
        <source>Filter the outline</source>
        <translation>アウトラインを絞り込む</translation>
    </message>
    <message>
        <source>Find in the project…</source>
        <translation>プロジェクト内を検索…</translation>
    </message>
    <message>
        <source>Find usages…</source>
        <translation>使用箇所を検索…</translation>
    </message>
    <message>
        <source>Follow a robot live.</source>
        <translation>ロボットの動きをその場で見ます。</translation>
    </message>
    <message>
        <source>Follow where it is</source>
        <translation>今いる場所を追う</translation>
    </message>
    <message>
        <source>Found before</source>
        <translation>前の検索結果</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Free of guides and grid</source>
        <translation>補助線とグリッドに合わせない</translation>
    </message>
    <message>
        <source>Give up a drag or a text; select the state again</source>
        <translation>ドラッグや文字入力をやめる・状態を選び直す</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Go back to before the changes</source>
        <translation>変更の前に戻す</translation>
    </message>
    <message>
        <source>Goes round states that belong together, and moves with them.</source>
        <translation>まとまりのある状態を囲み、一緒に動きます。</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Guard</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Holds when…</source>
        <translation>成り立つ条件…</translation>
    </message>
    <message>
        <source>How often people came to each state, how long, and where they gave up: as a table and on the drawings.</source>
        <translation>人がそれぞれの状態に何回来て、どのくらいいて、どこであきらめたか。表と図で見られます。</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>In which unit the data is, such as deg or m.</source>
        <translation>データの単位（deg、m など）。</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>入力欄</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>挿入</translation>
    </message>
    <message>
        <source>Into the part</source>
        <translation>部品の中へ</translation>
    </message>
    <message>
        <source>Is touched, and raises an event.</source>
        <translation>触れるとイベントを起こします。</translation>
    </message>
    <message>
        <source>Its name and languages, values at the start, settings for those who use the robot</source>
        <translation>名前と言語、最初の値、ロボットを使う人のための設定</translation>
    </message>
    <message>
        <source>Its time stands still, or goes on.</source>
        <translation>時間を止める・進める。</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Kind of value…</source>
        <translation>値の種類…</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Language, colours, and the keys of the commands.</source>
        <translation>言語、配色、コマンドのキー。</translation>
    </message>
    <message>
        <source>Launch</source>
        <translation>起動</translation>
    </message>
    <message>
        <source>Lead to…</source>
        <translation>行き先…</translation>
    </message>
    <message>
        <source>Left edges</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>List</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>Long pipes are folded into a chip with the number of the state.</source>
        <translation>長い線は、状態の番号を示す札に畳まれます。</translation>
    </message>
    <message>
        <source>Look at what a robot did before: all views show the moment that you choose.</source>
        <translation>ロボットの以前の動きを見ます。どの表示も、選んだ時点の様子になります。</translation>
    </message>
    <message>
        <source>Lower edges</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>Make a part…</source>
        <translation>部品にする…</translation>
    </message>
    <message>
        <source>Make them larger or smaller by 1 %, with Shift by 10 %</source>
        <translation>1 % ずつ大きさを変える（Shift で 10 %）</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Mend…</source>
        <translation>直す…</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Middles, one above the other</source>
        <translation>中央（縦並び）</translation>
    </message>
    <message>
        <source>Middles, side by side</source>
        <translation>中央（横並び）</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Move it by 1 %, with Shift by 10 %, with Alt by 0.1 %; remove it</source>
        <translation>1 % 動かす（Shift で 10 %、Alt で 0.1 %）、取り除く</translation>
    </message>
    <message>
        <source>Move the drawing</source>
        <translation>図を動かす</translation>
    </message>
    <message>
        <source>Move the selected cards</source>
        <translation>選んだカードを動かす</translation>
    </message>
    <message>
        <source>Move the selected components by 1 %, with Shift by 10 %</source>
        <translation>選んだ画面の部品を 1 % ずつ動かす（Shift で 10 %）</translation>
    </message>
    <message>
        <source>Moves every card to a place where the arrows are easy to follow.</source>
        <translation>矢印をたどりやすい位置にすべてのカードを動かします。</translation>
    </message>
    <message>
        <source>Moves one entry of a list to a tag.</source>
        <translation>一覧の一項目をタグに移します。</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>New lying guide</source>
        <translation>新しい横のガイド</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>新しいプロジェクト…</translation>
    </message>
    <message>
        <source>New upright guide</source>
        <translation>新しい縦のガイド</translation>
    </message>
    <message>
        <source>New window</source>
        <translation>新しいウィンドウ</translation>
    </message>
    <message>
        <source>Next difference</source>
        <translation>次の違い</translation>
    </message>
    <message>
        <source>Next document</source>
        <translation>次の文書</translation>
    </message>
    <message>
        <source>Next found</source>
        <translation>次の検索結果</translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation>次のパネル</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>次の問題</translation>
    </message>
    <message>
        <source>Next transition or pipe</source>
        <translation>次の遷移か線</translation>
    </message>
    <message>
        <source>None of these</source>
        <translation>どれも成り立たない</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>メモ…</translation>
    </message>
    <message>
        <source>Nothing pauses the robot any more; what is paused stays so until you let it go on.</source>
        <translation>もうロボットは止まりません。止まっているものは、再開するまで止まったままです。</translation>
    </message>
    <message>
        <source>Of a module in the selected situation, also one that is taken over.</source>
        <translation>選んだ状況でのモジュールの優先度。引き継いだものも変えられます。</translation>
    </message>
    <message>
        <source>Of all screens of this application.</source>
        <translation>このアプリケーションのすべての画面から。</translation>
    </message>
    <message>
        <source>Once current, the situation holds until this does.</source>
        <translation>いったん現在の状況になると、これが成り立つまで続きます。</translation>
    </message>
    <message>
        <source>One more test of data for the selected situation.</source>
        <translation>選んだ状況にデータの判定を一つ加えます。</translation>
    </message>
    <message>
        <source>One test of a value on the blackboard; a situation holds while all of its tests do.</source>
        <translation>ブラックボード上の値を調べます。すべてが成り立つ間、状況は成り立ちます。</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>横に開く</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>重なり順</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Panel before</source>
        <translation>前のパネル</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Pause the rehearsal, or go on</source>
        <translation>リハーサルを一時停止・続ける</translation>
    </message>
    <message>
        <source>Plays a sound of the media folder.</source>
        <translation>メディアフォルダーの音を鳴らします。</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>設定…</translation>
    </message>
    <message>
        <source>Previous difference</source>
        <translation>前の違い</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>印刷…</translation>
    </message>
    <message>
        <source>Priority…</source>
        <translation>優先度…</translation>
    </message>
    <message>
        <source>Problem before</source>
        <translation>前の問題</translation>
    </message>
    <message>
        <source>Put on the grid</source>
        <translation>グリッドに揃える</translation>
    </message>
    <message>
        <source>Puts a value at the end of the list at a tag.</source>
        <translation>タグの一覧の末尾に値を加えます。</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Raise an event…</source>
        <translation>イベントを起こす…</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>リハーサル</translation>
    </message>
    <message>
        <source>Remove all breakpoints</source>
        <translation>ブレークポイントをすべて取り除く</translation>
    </message>
    <message>
        <source>Remove all guides</source>
        <translation>ガイドをすべて取り除く</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前の変更</translation>
    </message>
    <message>
        <source>Rename everywhere…</source>
        <translation>すべての箇所で名前を変更…</translation>
    </message>
    <message>
        <source>Rename file…</source>
        <translation>ファイルの名前を変える…</translation>
    </message>
    <message>
        <source>Rename the file of the row</source>
        <translation>行のファイルの名前を変える</translation>
    </message>
    <message>
        <source>Rename the selected card; Tab goes on to the next one</source>
        <translation>選んだカードの名前を変える。Tab で次へ</translation>
    </message>
    <message>
        <source>Reopen closed tab</source>
        <translation>閉じたタブを開き直す</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>配置を初期状態に戻す</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Right edges</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Run all scenarios</source>
        <translation>すべてのシナリオを実行</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>コピーを保存…</translation>
    </message>
    <message>
        <source>Save as a recording…</source>
        <translation>記録として保存…</translation>
    </message>
    <message>
        <source>Save the rehearsal as a scenario…</source>
        <translation>リハーサルをシナリオとして保存…</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Script of situations</source>
        <translation>状況のスクリプト</translation>
    </message>
    <message>
        <source>Seconds after which the situation ends at the latest.</source>
        <translation>遅くともこの秒数で状況は終わります。</translation>
    </message>
    <message>
        <source>Seconds that the situation stays once it is current.</source>
        <translation>現在の状況になってから続く秒数。</translation>
    </message>
    <message>
        <source>See what the robot would do differently, and have it run what is open here.</source>
        <translation>ロボットの動きがどう変わるかを見て、ここで開いているものを動かします。</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Select all components</source>
        <translation>画面の部品をすべて選ぶ</translation>
    </message>
    <message>
        <source>Select nothing; give up a drag</source>
        <translation>選択を解く・ドラッグをやめる</translation>
    </message>
    <message>
        <source>Send backward</source>
        <translation>背面へ</translation>
    </message>
    <message>
        <source>Send the robot here</source>
        <translation>ロボットをここへ</translation>
    </message>
    <message>
        <source>Send to the back</source>
        <translation>最背面へ</translation>
    </message>
    <message>
        <source>Sends a message to whoever listens to its topic.</source>
        <translation>トピックを聞いているものにメッセージを送ります。</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>サービス</translation>
    </message>
    <message>
        <source>Set a value…</source>
        <translation>値を設定…</translation>
    </message>
    <message>
        <source>Set value</source>
        <translation>値の設定</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>ドラッグ中に Shift</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Show the log</source>
        <translation>ログを表示</translation>
    </message>
    <message>
        <source>Show the selection</source>
        <translation>選択範囲を表示</translation>
    </message>
    <message>
        <source>Shows first what still refers to it; Undo brings it back.</source>
        <translation>まだ参照しているものを先に示します。「元に戻す」で戻せます。</translation>
    </message>
    <message>
        <source>Shows the application that the selected state runs.</source>
        <translation>選んだ状態が動かすアプリケーションを表示します。</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Situations and modules as a table of priorities</source>
        <translation>状況とモジュールを優先度の表で</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Space and drag</source>
        <translation>Space とドラッグ</translation>
    </message>
    <message>
        <source>Speech</source>
        <translation>発話</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>ここから始める</translation>
    </message>
    <message>
        <source>Starts a program that the robot allows.</source>
        <translation>ロボットが許すプログラムを起動します。</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>States, texts, events and tags in every document.</source>
        <translation>すべての文書の状態、文章、イベント、タグ。</translation>
    </message>
    <message>
        <source>Stay at least…</source>
        <translation>最低継続時間…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>一つ進める</translation>
    </message>
    <message>
        <source>Step in the rehearsal</source>
        <translation>リハーサルを一つ進める</translation>
    </message>
    <message>
        <source>Tab behind the last component</source>
        <translation>最後の部品の次で Tab</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab、Shift+Tab</translation>
    </message>
    <message>
        <source>Take from</source>
        <translation>取り出す</translation>
    </message>
    <message>
        <source>Take over from…</source>
        <translation>引き継ぎ元…</translation>
    </message>
    <message>
        <source>Take the changes into the rehearsal</source>
        <translation>変更をリハーサルに取り入れる</translation>
    </message>
    <message>
        <source>Take the group away</source>
        <translation>まとまりを解く</translation>
    </message>
    <message>
        <source>Take the priority away here</source>
        <translation>ここで優先度を取り去る</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>The application stops where it is; the script goes on.</source>
        <translation>アプリケーションはその場で止まり、スクリプトは動き続けます。</translation>
    </message>
    <message>
        <source>The cursor goes to where the runs part next, and it is said what each robot did.</source>
        <translation>カーソルが次に分かれるところへ移り、それぞれのロボットがしたことを伝えます。</translation>
    </message>
    <message>
        <source>The cursor goes to where the runs parted before.</source>
        <translation>カーソルが前に分かれたところへ移ります。</translation>
    </message>
    <message>
        <source>The drawing is shown as it is drawn again.</source>
        <translation>図を描いたとおりの表示に戻します。</translation>
    </message>
    <message>
        <source>The drawing moves along when the robot goes to another state or situation.</source>
        <translation>ロボットが別の状態や状況へ移ると、図もいっしょに動きます。</translation>
    </message>
    <message>
        <source>The drawing, or a part of it, as SVG, PDF or PNG.</source>
        <translation>図の全体または一部を SVG、PDF、PNG にします。</translation>
    </message>
    <message>
        <source>The entries of a list on the blackboard, to choose one.</source>
        <translation>ブラックボードの一覧から一つを選びます。</translation>
    </message>
    <message>
        <source>The first column of the range into the others (Ctrl+R in the table)</source>
        <translation>範囲の最初の列をほかの列へ（表では Ctrl+R）</translation>
    </message>
    <message>
        <source>The first row of the range into the others (Ctrl+D in the table)</source>
        <translation>範囲の最初の行をほかの行へ（表では Ctrl+D）</translation>
    </message>
    <message>
        <source>The graph, and below it the priorities as a table</source>
        <translation>グラフと、その下に優先度の表</translation>
    </message>
    <message>
        <source>The graph, and beside it the screen of the selected state</source>
        <translation>グラフと、その横に選んだ状態の画面</translation>
    </message>
    <message>
        <source>The guides, one after the other</source>
        <translation>ガイドを順に</translation>
    </message>
    <message>
        <source>The module can not move the robot in this situation, whatever it takes over.</source>
        <translation>何を引き継いでいても、この状況ではモジュールはロボットを動かせません。</translation>
    </message>
    <message>
        <source>The next card in that direction</source>
        <translation>その方向の次のカード</translation>
    </message>
    <message>
        <source>The next card whose name or number begins so</source>
        <translation>名前か番号がそう始まる次のカード</translation>
    </message>
    <message>
        <source>The next card, the card before, in the order of the document</source>
        <translation>文書の順で次のカード・前のカード</translation>
    </message>
    <message>
        <source>The next component, the one before</source>
        <translation>次・前の画面の部品</translation>
    </message>
    <message>
        <source>The paused application does the next thing that waits.</source>
        <translation>止まっているアプリケーションが、次に待っていることを行います。</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>The project goes into another folder as it is here, and you go on there.</source>
        <translation>今の内容でプロジェクトを別のフォルダーに保存し、そこで作業を続けます。</translation>
    </message>
    <message>
        <source>The project runs here, without a robot, from its start.</source>
        <translation>ロボットなしで、プロジェクトを最初からここで動かします。</translation>
    </message>
    <message>
        <source>The recording is left; what is live is shown again.</source>
        <translation>記録を離れ、今の動きの表示に戻ります。</translation>
    </message>
    <message>
        <source>The robot moves: one of its resources gets a command.</source>
        <translation>ロボットが動きます。リソースの一つに指令を送ります。</translation>
    </message>
    <message>
        <source>The robot pauses here only while something holds, such as a value above a limit.</source>
        <translation>値が上限を超えているなど、何かが成り立つ間だけ、ロボットがここで止まります。</translation>
    </message>
    <message>
        <source>The robot pauses when it comes to this state, takes this transition, or is in this situation.</source>
        <translation>この状態に入るとき、この遷移のとき、またはこの状況のとき、ロボットが止まります。</translation>
    </message>
    <message>
        <source>The robot says something.</source>
        <translation>ロボットが話します。</translation>
    </message>
    <message>
        <source>The robot&apos;s application leaves its state for this one.</source>
        <translation>ロボットのアプリケーションが今の状態からこの状態へ移ります。</translation>
    </message>
    <message>
        <source>The screen of the selected state, drawn to scale</source>
        <translation>選んだ状態の画面を正しい比率で</translation>
    </message>
    <message>
        <source>The selected cards, or all, to the nearest points of the grid.</source>
        <translation>選んだカード（なければすべて）を最も近い格子点へ。</translation>
    </message>
    <message>
        <source>The selected states become an application of their own, which one state runs.</source>
        <translation>選んだ状態を独立したアプリケーションにし、一つの状態がそれを動かします。</translation>
    </message>
    <message>
        <source>The selected tests hold together when all of them do.</source>
        <translation>選んだ判定は、すべてが成り立つときに成り立ちます。</translation>
    </message>
    <message>
        <source>The selected tests hold together when none of them does.</source>
        <translation>選んだ判定は、どれも成り立たないときに成り立ちます。</translation>
    </message>
    <message>
        <source>The selected tests hold together when one of them does.</source>
        <translation>選んだ判定は、どれか一つが成り立つときに成り立ちます。</translation>
    </message>
    <message>
        <source>The situation whose priorities count in the selected one too.</source>
        <translation>選んだ状況でも優先度が有効になる状況。</translation>
    </message>
    <message>
        <source>The start</source>
        <translation>開始状態</translation>
    </message>
    <message>
        <source>The states of the part stand here again; its file stays.</source>
        <translation>部品の状態がここに戻ります。ファイルは残ります。</translation>
    </message>
    <message>
        <source>The tests in the selected group stay.</source>
        <translation>まとまりの中の判定は残ります。</translation>
    </message>
    <message>
        <source>This document in a second group of tabs, beside the first.</source>
        <translation>この文書を横の二つ目のタブ群で開きます。</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>To the form of the component</source>
        <translation>画面の部品の入力欄へ</translation>
    </message>
    <message>
        <source>To what happens next if nobody does anything.</source>
        <translation>誰も何もしないとき、次に起こることまで進みます。</translation>
    </message>
    <message>
        <source>Transition or pipe before</source>
        <translation>前の遷移か線</translation>
    </message>
    <message>
        <source>Tutorial</source>
        <translation>チュートリアル</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Unit…</source>
        <translation>単位…</translation>
    </message>
    <message>
        <source>Until…</source>
        <translation>終了条件…</translation>
    </message>
    <message>
        <source>Upper edges</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>Versions on the robot…</source>
        <translation>ロボットにあるバージョン…</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Welcome page</source>
        <translation>ようこそページ</translation>
    </message>
    <message>
        <source>What a robot needs of the project, in a folder of its own, to be carried there.</source>
        <translation>プロジェクトのうちロボットに要るものを、持ち運べるように別のフォルダーへ出します。</translation>
    </message>
    <message>
        <source>What can be done about the problems of what is selected.</source>
        <translation>選んだものの問題に対してできること。</translation>
    </message>
    <message>
        <source>What can be done with the selection</source>
        <translation>選んだものにできること</translation>
    </message>
    <message>
        <source>What follows too</source>
        <translation>後に続くものも</translation>
    </message>
    <message>
        <source>What happens when nothing happens.</source>
        <translation>何も起こらないときにどうなるか。</translation>
    </message>
    <message>
        <source>What is going on, and who may use the robot then.</source>
        <translation>何が起きているか、そのとき誰がロボットを使えるか。</translation>
    </message>
    <message>
        <source>What is part of every state: a Home button, a timeout, what people may say at any time.</source>
        <translation>すべての状態に共通のもの：ホームボタン、時間切れ、いつでも言える言葉。</translation>
    </message>
    <message>
        <source>What is seen of the robot is written into a file: to be looked at, compared and counted later.</source>
        <translation>ロボットについて見えているものをファイルに書きます。あとで見たり、比べたり、数えたりできます。</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>これは何？</translation>
    </message>
    <message>
        <source>What is to be remembered about what is selected; of nothing, about the script.</source>
        <translation>選んだものについての覚え書き。何も選ばなければスクリプトについて。</translation>
    </message>
    <message>
        <source>What its developer says of a module.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What kept it from happening at this moment: a guard, a priority, a suspension.</source>
        <translation>この時点で起きなかった理由。条件、優先度、一時中断など。</translation>
    </message>
    <message>
        <source>What leads here too</source>
        <translation>前にあるものも</translation>
    </message>
    <message>
        <source>What led to it, from the input that began it, with the values then.</source>
        <translation>きっかけの入力からの経緯と、そのときの値。</translation>
    </message>
    <message>
        <source>What lies under the selected component</source>
        <translation>選んだ画面の部品の下にあるもの</translation>
    </message>
    <message>
        <source>What ran in the rehearsal before the last changes runs again, at once.</source>
        <translation>リハーサルを、最後の変更の前の内容にすぐに戻します。</translation>
    </message>
    <message>
        <source>What runs goes on as it is drawn now, from a moment at which no action runs.</source>
        <translation>動作がないときから、今描かれている内容で続けます。</translation>
    </message>
    <message>
        <source>What the robot shows, says and waits for.</source>
        <translation>ロボットが見せ、話し、待つもの。</translation>
    </message>
    <message>
        <source>What the state waits for, and where it leads.</source>
        <translation>状態が待つものと、その行き先。</translation>
    </message>
    <message>
        <source>What the studio noted lately, for a report: names of files, no texts of yours.</source>
        <translation>報告のための最近の記録：ファイル名のみで、あなたの文章は含まれません。</translation>
    </message>
    <message>
        <source>What they take over counts again (Del in the table)</source>
        <translation>引き継いだ優先度に戻ります（表では Del）</translation>
    </message>
    <message>
        <source>What was deployed when and by whom; go back to a former version.</source>
        <translation>いつ誰が何を配備したか。前のバージョンに戻せます。</translation>
    </message>
    <message>
        <source>What was done can be done again, and what happened is expected then.</source>
        <translation>したことをもう一度でき、起きたことが期待になります。</translation>
    </message>
    <message>
        <source>What was paused goes on.</source>
        <translation>止まっていたものが続きます。</translation>
    </message>
    <message>
        <source>What you click next is explained, and nothing else is done with it.</source>
        <translation>次にクリックしたものを説明します。ほかには何もしません。</translation>
    </message>
    <message>
        <source>When the selected transition may be taken.</source>
        <translation>選んだ遷移が起こってよい条件。</translation>
    </message>
    <message>
        <source>When which module may move the robot. The project has no script yet.</source>
        <translation>いつどのモジュールがロボットを動かしてよいか。プロジェクトにはまだスクリプトがありません。</translation>
    </message>
    <message>
        <source>Where it leads</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>Whether the data is a number, a text, yes or no.</source>
        <translation>データが数値か、文字か、はい・いいえか。</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>なぜ起きない？</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>なぜ？</translation>
    </message>
    <message>
        <source>Words on the screen.</source>
        <translation>画面の文字。</translation>
    </message>
    <message>
        <source>Write another text</source>
        <translation>別の文字を書く</translation>
    </message>
    <message>
        <source>Write the component&apos;s text where it stands</source>
        <translation>画面の部品の文字をその場で書く</translation>
    </message>
    <message>
        <source>Writes a value on the blackboard.</source>
        <translation>ブラックボードに値を書き込みます。</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>拡大・縮小</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>日本語</source>
        <translation>日本語</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>キャンバス上</translation>
    </message>
    <message>
        <source>In the project&apos;s tree</source>
        <translation>プロジェクトのツリーで</translation>
    </message>
    <message>
        <source>On the screen of a state</source>
        <translation>状態の画面で</translation>
    </message>
</context>
<context>
    <name>fields</name>
    <message>
        <source>the same state, anew</source>
        <translation>同じ状態をもう一度</translation>
    </message>
    <message>
        <source>back to where it came from</source>
        <translation>元の状態に戻る</translation>
    </message>
</context>
<context>
    <name>help</name>
    <message>
        <source>A condition is one test, or a group of which all, any or none must hold. A test that has no value to look at does not hold; “exists” asks just that. Take care with “is not”: it does not hold either while there is no value.</source>
        <translation>条件は一つの判定か、「すべて」「いずれか」「どれも〜ない」のまとまりです。見る値がない判定は成り立ちません。値があるかどうかは「存在する」で調べます。「〜でない」には注意してください。値がない間は、これも成り立ちません。</translation>
    </message>
    <message>
        <source>A few letters of a command, state or situation are enough.</source>
        <translation>コマンド、状態、状況の名前の数文字で探せます。</translation>
    </message>
    <message>
        <source>A file with errors that could not be read whole is shown, but not changed, until the errors are mended: else what they name would be lost.</source>
        <translation>誤りがあって全部は読めなかったファイルは、表示はしますが、直るまで変更しません。書かれていたものが失われないようにするためです。</translation>
    </message>
    <message>
        <source>A project is a folder. Its applications say what the robot shows, says and waits for; its script says which of the robot&apos;s modules may move it in which situation.</source>
        <translation>プロジェクトは一つのフォルダーです。アプリケーションは、ロボットが何を見せ、話し、待つかを表します。スクリプトは、どの状況でどのモジュールがロボットを動かしてよいかを表します。</translation>
    </message>
    <message>
        <source>A script decides who may move the robot. Data is looked at by conditions; the first situation from the top whose conditions hold is the current one; it gives each module a priority. Of the modules that ask for the same part of the robot, the one with the highest priority gets it.</source>
        <translation>誰がロボットを動かしてよいかはスクリプトが決めます。条件がデータを見て、上から最初に条件が成り立った状況が現在の状況になり、各モジュールに優先度を与えます。ロボットの同じ部分を要求するモジュールのうち、優先度が最も高いものが使います。</translation>
    </message>
    <message>
        <source>A situation may take over another one&apos;s priorities and change some. A module without a priority gets nothing in that situation. The last situation has no conditions, so that there always is one.</source>
        <translation>状況は別の状況の優先度を引き継ぎ、一部を変えられます。優先度のないモジュールは、その状況では何も使えません。いつも何かの状況になるように、最後の状況には条件がありません。</translation>
    </message>
    <message>
        <source>A tag in braces, such as {user.name}, shows a value of the blackboard and follows its changes. A touch on a button raises its event, for which the state must wait. Keep buttons at least 12 mm high: people with unsteady hands have to hit them.</source>
        <translation>{user.name} のように波括弧で囲んだタグは、ブラックボードの値を表示し、変化に合わせて変わります。ボタンに触れるとイベントが起きるので、状態がそれを待っている必要があります。ボタンの高さは 12 mm 以上にしてください。手の震える人でも押せるようにするためです。</translation>
    </message>
    <message>
        <source>Actions are done when a state is entered, or on the way to another one. They start from first to last without waiting for each other, unless “Wait for it” is on.</source>
        <translation>動作は、状態に入ったとき、または別の状態へ移る途中で行われます。「終わりを待つ」を付けない限り、互いを待たずに上から順に始まります。</translation>
    </message>
    <message>
        <source>All keys in a list that can be searched.</source>
        <translation>すべてのキーを、検索できる一覧で表示します。</translation>
    </message>
    <message>
        <source>An application is a graph of states. In a state the robot shows a screen, does its actions from first to last, and waits for an event: a touch, a spoken answer, a message, the end of an action, or a timeout.</source>
        <translation>アプリケーションは状態のグラフです。状態の中でロボットは画面を見せ、動作を順に行い、イベントを待ちます。イベントとは、画面に触れること、声の返事、メッセージ、動作の終わり、時間切れです。</translation>
    </message>
    <message>
        <source>An empty project in a folder of its own.</source>
        <translation>新しいフォルダーに空のプロジェクトを作ります。</translation>
    </message>
    <message>
        <source>An edit does not change what runs. Take in lets it go on with the changes, by the rules of a deploy: at the next moment at which no action runs, from the state in which it is. What then goes wrong within a minute is gone back from; Go back does so at any time. Start again runs it from the start.</source>
        <translation>変更しても、動いているものは変わりません。「取り入れる」を使うと、配備と同じきまりで、次に動作のない時点から、今の状態のまま変更後のものに移ります。そのあと 1 分のうちにうまくいかなければ元に戻ります。「元に戻す」はいつでも使えます。「もう一度始める」は最初から動かします。</translation>
    </message>
    <message>
        <source>An operator may do more: a breakpoint (F9) pauses an application at a state, before a transition, or in a situation, with a condition (Shift+F9) only while that holds; what was set in a project is offered to the next robot. Step does the next thing that waits; an event is raised, a value set, the robot sent to a state. Who did it stands in the trace.</source>
        <translation>操作者にはさらにできることがあります。ブレークポイント (F9) は、状態や遷移の前、状況でアプリケーションを止めます。条件を付けると (Shift+F9)、それが成り立つ間だけ止まります。プロジェクトで付けたものは、次のロボットにも付けるかどうかを選べます。「ステップ」は待っている次のことを一つ進めます。イベントを起こす、値を入れる、ロボットを別の状態へ送ることもできます。誰がしたかは記録に残ります。</translation>
    </message>
    <message>
        <source>Another name for what is selected, in its place.</source>
        <translation>選んだものの名前をその場で変えます。</translation>
    </message>
    <message>
        <source>Another window, for another project.</source>
        <translation>別のプロジェクト用に、もう一つウィンドウを開きます。</translation>
    </message>
    <message>
        <source>Asks first where something is not saved.</source>
        <translation>保存していないものがあれば、先に尋ねます。</translation>
    </message>
    <message>
        <source>Authority</source>
        <translation>実行権</translation>
    </message>
    <message>
        <source>Before all other components of the screen.</source>
        <translation>画面のほかのすべての部品より手前へ。</translation>
    </message>
    <message>
        <source>Before the next component.</source>
        <translation>次の部品より手前へ。</translation>
    </message>
    <message>
        <source>Begin with an example or a template from the welcome page: a copy is made, so nothing can be spoilt. Click a card and look at its form at the right. Change a text, press Enter, and take it back with Ctrl+Z: every change is one step with a name, and all of them can be undone.</source>
        <translation>最初のページの例かひな形から始めてください。写しが作られるので、何も壊れません。カードをクリックして、右の入力欄を見てください。文字を変えて Enter を押し、Ctrl+Z で元に戻してみましょう。変更は一つずつ名前の付いた操作になり、すべて元に戻せます。</translation>
    </message>
    <message>
        <source>Behind all other components of the screen.</source>
        <translation>画面のほかのすべての部品より奥へ。</translation>
    </message>
    <message>
        <source>Behind the next component.</source>
        <translation>次の部品より奥へ。</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>ブラックボード</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>ブレークポイント</translation>
    </message>
    <message>
        <source>Cards and arrows.</source>
        <translation>カードと矢印。</translation>
    </message>
    <message>
        <source>Cards as large as they are drawn.</source>
        <translation>カードを描いたとおりの大きさで。</translation>
    </message>
    <message>
        <source>Click a card or an arrow to select it; drag the ground to select several, hold Space to move the drawing, Ctrl and wheel to zoom.</source>
        <translation>カードや矢印はクリックで選びます。空いたところをドラッグするとまとめて選べます。Space を押しながらで図の移動、Ctrl とホイールで拡大・縮小です。</translation>
    </message>
    <message>
        <source>Click a problem to go there; F8 goes from one to the next. Where a mend is offered, one click does it, and undo takes it back. The form of what is wrong says it again above its fields.</source>
        <translation>問題をクリックするとその場所へ移ります。F8 で次の問題へ。直し方が示されていれば、一度のクリックで直り、「元に戻す」で戻せます。誤りのあるものの入力欄の上にも、同じ説明が出ます。</translation>
    </message>
    <message>
        <source>Closes all windows; asks first where something is not saved.</source>
        <translation>すべてのウィンドウを閉じます。保存していないものがあれば、先に尋ねます。</translation>
    </message>
    <message>
        <source>Compare, in the timeline, puts another recording below the run that is shown. F4 goes to where they part next, and says what each robot did; when it did it does not count. Count recordings tells over many runs how often people came to each state, how long, and where they gave up: in the panel Field, and on the drawings.</source>
        <translation>タイムラインの「比べる」は、表示中の実行の下に別の記録を並べます。F4 で次に分かれるところへ移り、それぞれのロボットがしたことを伝えます。いつしたかの違いは数えません。「記録を数える」は、多くの実行を通して、人がそれぞれの状態に何回来て、どのくらいいて、どこであきらめたかを、「現場」パネルと図で示します。</translation>
    </message>
    <message>
        <source>Connect to a robot by its address. Its state and its situation glow in the drawings, and the tables below the canvas show what is on the blackboard, who holds which part of the robot, and what happened.</source>
        <translation>アドレスを指定してロボットに接続します。今の状態と状況が図の中で光り、下の表に、ブラックボードの中身、ロボットの各部分を誰が使っているか、何が起きたかが表示されます。</translation>
    </message>
    <message>
        <source>Ctrl+K finds any command, state or situation by a few letters, Ctrl+F every text of the project. F1 explains what you are at; Shift+F1 explains what you click next. Keys are changed in the preferences.</source>
        <translation>Ctrl+K は数文字でコマンド、状態、状況を探し、Ctrl+F はプロジェクトの文字を探します。F1 は今の対象を、Shift+F1 は次にクリックしたものを説明します。キーは環境設定で変えられます。</translation>
    </message>
    <message>
        <source>Dark letters on light ground.</source>
        <translation>明るい地に暗い文字。</translation>
    </message>
    <message>
        <source>Deploy has the robot run what is open here, from its next safe point on. What it will do differently is told before in words. If it fails in its first minute the robot goes back by itself; Roll back does so at any time.</source>
        <translation>「配備」は、ここで開いているものを、次の安全な切り替え時からロボットに動かします。動きの違いは先に言葉で示します。最初の一分で失敗すると、ロボットは自分で前に戻ります。「前に戻す」でいつでも戻せます。</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>元に戻したことをやり直します。</translation>
    </message>
    <message>
        <source>Drag from the dot at the right of a card to another card to lead there, or to the empty ground for a new state. Drop a card on an arrow to put it between. “In every state” holds what is part of all of them, such as a Home button.</source>
        <translation>カードの右の点から別のカードへドラッグすると、そこへつながります。空いたところへドラッグすると新しい状態ができます。カードを矢印の上に置くと間に入ります。「すべての状態」には、ホームボタンのように、どの状態にもあるものを置きます。</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Each of the selected states leads to the next.</source>
        <translation>選んだ状態を順につなぎます。</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Every place in which a text or a name stands.</source>
        <translation>文字や名前が出てくるすべての場所。</translation>
    </message>
    <message>
        <source>Everything larger.</source>
        <translation>全体を大きく。</translation>
    </message>
    <message>
        <source>Everything smaller.</source>
        <translation>全体を小さく。</translation>
    </message>
    <message>
        <source>Everything works without a mouse. F6 goes from panel to panel, Tab from field to field, arrows from card to card; letters go to the card whose name begins so; Enter renames. The outline has all that the drawing has, as rows for the keyboard and for screen readers.</source>
        <translation>何でもマウスなしでできます。F6 でパネルからパネルへ、Tab で欄から欄へ、矢印でカードからカードへ移ります。文字を打つと、名前がその文字で始まるカードへ移り、Enter で名前を変えます。アウトラインには図の内容がすべて行として並び、キーボードや読み上げで使えます。</translation>
    </message>
    <message>
        <source>Examples, templates and the projects of before; this one stays open.</source>
        <translation>例、ひな形、以前のプロジェクト。今のものは開いたままです。</translation>
    </message>
    <message>
        <source>Explains what is selected, or where the keyboard is.</source>
        <translation>選んだもの、またはキーボードの位置にあるものを説明します。</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>現場</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>はじめに</translation>
    </message>
    <message>
        <source>Following a robot</source>
        <translation>ロボットの動きを見る</translation>
    </message>
    <message>
        <source>Following changes nothing on the robot. Where its documents differ from yours, that is told, since the drawing may not be what the robot does.</source>
        <translation>見ているだけでは、ロボットは何も変わりません。ロボットの文書が手元と違うときは、図とロボットの動きが違うことがあるので、そう表示します。</translation>
    </message>
    <message>
        <source>Goes to the next place that was found.</source>
        <translation>次に見つかった場所へ移ります。</translation>
    </message>
    <message>
        <source>Goes to the place before that was found.</source>
        <translation>前に見つかった場所へ移ります。</translation>
    </message>
    <message>
        <source>Goes where the next problem is.</source>
        <translation>次の問題の場所へ移ります。</translation>
    </message>
    <message>
        <source>Goes where the problem before is.</source>
        <translation>前の問題の場所へ移ります。</translation>
    </message>
    <message>
        <source>How much is probably not meant. A click shows it.</source>
        <translation>おそらく意図と違うところの数。クリックで表示します。</translation>
    </message>
    <message>
        <source>How much is selected.</source>
        <translation>選んでいるものの数。</translation>
    </message>
    <message>
        <source>How much there is in the shown document.</source>
        <translation>表示中の文書にあるものの数。</translation>
    </message>
    <message>
        <source>How much there is that can not work. A click shows it.</source>
        <translation>動かないところの数。クリックで表示します。</translation>
    </message>
    <message>
        <source>How often, how long, and where people gave up, counted over recordings. A click goes to the state; a head sorts.</source>
        <translation>記録全体で数えた、回数、時間、あきらめたところ。クリックでその状態へ、見出しで並べ替えます。</translation>
    </message>
    <message>
        <source>In a script a test can look at time too. “Within” holds while the value was set less than so many seconds ago; “for” holds once it has been so without a break.</source>
        <translation>スクリプトの判定では時間も見られます。「以内」は、値が書き込まれてからその秒数の間だけ成り立ちます。「継続」は、途切れずにその秒数続いてから成り立ちます。</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>インスペクター</translation>
    </message>
    <message>
        <source>Keeps what is selected to be pasted, in other projects too.</source>
        <translation>選んだものを貼り付けのために覚えます。別のプロジェクトにも貼り付けられます。</translation>
    </message>
    <message>
        <source>Larger letters; drawings are made larger by zooming.</source>
        <translation>文字を大きく。図はズームで大きくします。</translation>
    </message>
    <message>
        <source>Letters are as large as the computer&apos;s others.</source>
        <translation>文字の大きさをコンピューターのほかの文字に合わせます。</translation>
    </message>
    <message>
        <source>Letters of the usual size.</source>
        <translation>ふつうの大きさの文字。</translation>
    </message>
    <message>
        <source>Light letters on dark ground.</source>
        <translation>暗い地に明るい文字。</translation>
    </message>
    <message>
        <source>Light or dark, as the computer is set.</source>
        <translation>明るいか暗いかは、コンピューターの設定に従います。</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Much larger letters; drawings are made larger by zooming.</source>
        <translation>文字をかなり大きく。図はズームで大きくします。</translation>
    </message>
    <message>
        <source>One for each open document; at the right, the ways in which it can be shown.</source>
        <translation>開いている文書ごとに一つ。右側で表示のしかたを選びます。</translation>
    </message>
    <message>
        <source>Only the rows of the outline in which a word stands.</source>
        <translation>アウトラインのうち、言葉を含む行だけ。</translation>
    </message>
    <message>
        <source>Other actions write to the blackboard: set a value, add to a number, append to a list, take from one. Services ask a web address, a module or a file, and keep the answer. Launch begins another application.</source>
        <translation>ほかの動作はブラックボードに書き込みます。値の設定、数への加算、一覧への追加、一覧からの取り出しです。サービスは、ウェブのアドレス、モジュール、ファイルに問い合わせ、答えを取っておきます。「起動」は別のプログラムを始めます。</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>パレット</translation>
    </message>
    <message>
        <source>Panels are dragged by their headings: to another side, or out of the window. The right button on a heading closes them; View, Panels brings them back, and Reset layout puts all where they were.</source>
        <translation>パネルは見出しをドラッグして、別の側やウィンドウの外へ動かせます。見出しの右クリックで閉じ、「表示」の「パネル」で戻します。「配置を元に戻す」ですべて最初の位置に戻ります。</translation>
    </message>
    <message>
        <source>Panels, keys and finding things</source>
        <translation>パネル、キー、検索</translation>
    </message>
    <message>
        <source>Places and sizes are in percent, so that a screen fits every display. Components snap to the grid and to each other; hold Alt to place them freely. Later ones lie in front of earlier ones.</source>
        <translation>位置と大きさは百分率なので、どの大きさの画面にも合います。部品はグリッドや互いの位置に揃います。Alt を押している間は自由に置けます。後のものほど手前に重なります。</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Problems and how to mend them</source>
        <translation>問題とその直し方</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Puts another one of what is selected beside it.</source>
        <translation>選んだものと同じものを横に置きます。</translation>
    </message>
    <message>
        <source>Puts in what was cut or copied; numbers and names that are taken become new ones.</source>
        <translation>切り取ったかコピーしたものを入れます。使われている番号や名前は新しくなります。</translation>
    </message>
    <message>
        <source>Rehearsal</source>
        <translation>リハーサル</translation>
    </message>
    <message>
        <source>Rehearse (F5) runs the project as it is drawn, here, from its start. Touch the robot&apos;s screen, let people say what it listens for, turn data, let modules ask: the drawings and tables show what comes of it, as they do with a robot.</source>
        <translation>「リハーサル」（F5）は、描いたとおりのプロジェクトを最初からここで動かします。ロボットの画面に触れ、人の言葉を聞かせ、データを変え、モジュールに要求させると、その結果がロボットのときと同じように図と表に出ます。</translation>
    </message>
    <message>
        <source>Rehearsing without a robot</source>
        <translation>ロボットなしのリハーサル</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>シナリオ</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Selects all cards.</source>
        <translation>すべてのカードを選びます。</translation>
    </message>
    <message>
        <source>Selects the next one, without the mouse.</source>
        <translation>マウスを使わずに次のものを選びます。</translation>
    </message>
    <message>
        <source>Selects the one before, without the mouse.</source>
        <translation>マウスを使わずに前のものを選びます。</translation>
    </message>
    <message>
        <source>Selects the state in which the application starts.</source>
        <translation>アプリケーションが始まる状態を選びます。</translation>
    </message>
    <message>
        <source>Selects the state to which the selected transition leads.</source>
        <translation>選んだ遷移の行き先の状態を選びます。</translation>
    </message>
    <message>
        <source>Shows the application again in which the part is used.</source>
        <translation>部品を使っているアプリケーションに戻ります。</translation>
    </message>
    <message>
        <source>Shows the document again that was closed last.</source>
        <translation>最後に閉じた文書をもう一度表示します。</translation>
    </message>
    <message>
        <source>Shows the drawing as it comes on paper, on one page or several.</source>
        <translation>図を紙に印刷したときの様子を、一枚または複数枚で表示します。</translation>
    </message>
    <message>
        <source>Shows the project of a folder.</source>
        <translation>フォルダーのプロジェクトを表示します。</translation>
    </message>
    <message>
        <source>Situations and priorities</source>
        <translation>状況と優先度</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Smaller letters: more has room.</source>
        <translation>文字を小さく。より多くのものが入ります。</translation>
    </message>
    <message>
        <source>Speech and movement can end well or badly; give the names of the events that are raised then, and let the state expect them. When a state is left, what it still says or moves is stopped.</source>
        <translation>発話や動きは、うまく終わることも失敗することもあります。そのとき起こすイベントの名前を決め、状態に待たせてください。状態を出ると、まだ続いている発話や動きは止まります。</translation>
    </message>
    <message>
        <source>Speech and movements end by themselves after a while; for a service you say how it ended. The clock goes as fast as the one on the wall, ten times as fast, or from one thing that happens to the next.</source>
        <translation>発話や動きはしばらくすると自分で終わります。サービスがどう終わったかはあなたが決めます。時計は実際の速さ、10 倍の速さ、または次に起こることまで一気に進められます。</translation>
    </message>
    <message>
        <source>States and what leads on</source>
        <translation>状態と次への進み方</translation>
    </message>
    <message>
        <source>States that belong together can become a part: an application of its own that one state runs. A double click goes into it.</source>
        <translation>関係する状態は部品にまとめられます。部品は、一つの状態が動かす別のアプリケーションです。ダブルクリックで中へ入ります。</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>タブ</translation>
    </message>
    <message>
        <source>Takes the keyboard to the next panel.</source>
        <translation>キーボードを次のパネルへ移します。</translation>
    </message>
    <message>
        <source>Takes the keyboard to the panel before.</source>
        <translation>キーボードを前のパネルへ移します。</translation>
    </message>
    <message>
        <source>Takes the last change back, also after saving.</source>
        <translation>最後の変更を元に戻します。保存した後でもできます。</translation>
    </message>
    <message>
        <source>Takes what is selected away and keeps it to be pasted.</source>
        <translation>選んだものを取り去り、貼り付けのために覚えます。</translation>
    </message>
    <message>
        <source>Takes what is selected away, with the arrows that lead there.</source>
        <translation>選んだものを、そこへの矢印といっしょに取り去ります。</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>The application starts in the selected state.</source>
        <translation>アプリケーションは選んだ状態から始まります。</translation>
    </message>
    <message>
        <source>The blackboard holds what is known: each value stands at a tag, such as user.name or sound.loud. Modules, services, touches and actions write there; screens, speech and conditions read.</source>
        <translation>ブラックボードには、分かっていることが置かれます。値は user.name や sound.loud のようなタグにあります。モジュール、サービス、画面への接触、動作が書き込み、画面、発話、条件が読みます。</translation>
    </message>
    <message>
        <source>The computer&apos;s language, if the studio speaks it.</source>
        <translation>コンピューターの言語（対応しているとき）。</translation>
    </message>
    <message>
        <source>The document of the tab at the left.</source>
        <translation>左のタブの文書。</translation>
    </message>
    <message>
        <source>The document of the tab at the right.</source>
        <translation>右のタブの文書。</translation>
    </message>
    <message>
        <source>The document stays in the project.</source>
        <translation>文書はプロジェクトに残ります。</translation>
    </message>
    <message>
        <source>The documents of the project and its media. A click shows one in a tab.</source>
        <translation>プロジェクトの文書とメディア。クリックするとタブに表示します。</translation>
    </message>
    <message>
        <source>The drawing moves along with the robot (Follow where it is). On a card stands how often it came there, how long it stayed, and behind the clock how often the time ran out before anybody went on.</source>
        <translation>図はロボットといっしょに動きます（「今いる場所を追う」）。カードには、そこに何回来たか、どのくらいいたか、時計の印の後ろには誰も進めないまま何回時間切れになったかが出ます。</translation>
    </message>
    <message>
        <source>The first expected event that fits is taken. It may depend on a condition, do actions on the way, and lead to another state, back to the one before (#back), or into the same one anew (#again). Without a target the state stays.</source>
        <translation>待っているイベントのうち、最初に合ったものが選ばれます。イベントには条件や途中の動作を付けられ、行き先は、別の状態、前の状態（#back）、同じ状態への入り直し（#again）です。行き先がなければ状態は変わりません。</translation>
    </message>
    <message>
        <source>The form of what is selected. Enter ends a field.</source>
        <translation>選んだものの入力欄。Enter で欄の入力を終えます。</translation>
    </message>
    <message>
        <source>The gaps from left to right become equal.</source>
        <translation>左右の間隔を等しくします。</translation>
    </message>
    <message>
        <source>The gaps from top to bottom become equal.</source>
        <translation>上下の間隔を等しくします。</translation>
    </message>
    <message>
        <source>The largest letters; drawings are made larger by zooming.</source>
        <translation>いちばん大きな文字。図はズームで大きくします。</translation>
    </message>
    <message>
        <source>The left edges come to stand below each other.</source>
        <translation>左端を縦に揃えます。</translation>
    </message>
    <message>
        <source>The lower edges come to stand at one height.</source>
        <translation>下端を同じ高さに揃えます。</translation>
    </message>
    <message>
        <source>The menu of a problem, and Ctrl+. for what is selected, mend all of a kind at once, or accept a warning that you know and mean: it is told no more.</source>
        <translation>問題のメニューや、選んだものへの Ctrl+. で、同じ種類をまとめて直したり、承知のうえの警告を認めたりできます。認めた警告はもう出ません。</translation>
    </message>
    <message>
        <source>The menu that the right button opens.</source>
        <translation>右ボタンで開くメニュー。</translation>
    </message>
    <message>
        <source>The middles come to stand at one height.</source>
        <translation>上下の中央を同じ高さに揃えます。</translation>
    </message>
    <message>
        <source>The middles come to stand below each other.</source>
        <translation>左右の中央を縦に揃えます。</translation>
    </message>
    <message>
        <source>The priority of each module in each situation. Type a number; pale ones are taken over from another situation.</source>
        <translation>状況ごとのモジュールの優先度。数を入力します。淡色は別の状況から引き継いだものです。</translation>
    </message>
    <message>
        <source>The right edges come to stand below each other.</source>
        <translation>右端を縦に揃えます。</translation>
    </message>
    <message>
        <source>The robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>The robot goes on; it is followed no more.</source>
        <translation>ロボットは動き続けます。見るのをやめます。</translation>
    </message>
    <message>
        <source>The robot&apos;s screen, to be touched; what people say, data and modules. Nothing of it is in the documents.</source>
        <translation>触れるロボットの画面、人の言葉、データ、モジュール。どれも文書には入りません。</translation>
    </message>
    <message>
        <source>The same as rows of a table, for keyboard and screen reader.</source>
        <translation>同じ内容を表の行で。キーボードと読み上げに向いています。</translation>
    </message>
    <message>
        <source>The same script can be seen as a drawing or as a matrix of situations and modules. Give the robot a situation that stops it, and put it first.</source>
        <translation>同じスクリプトを、図としても、状況とモジュールの表としても見られます。ロボットを止める状況を作り、最初に置いてください。</translation>
    </message>
    <message>
        <source>The smallest letters: more has room.</source>
        <translation>いちばん小さな文字。より多くのものが入ります。</translation>
    </message>
    <message>
        <source>The status bar says honestly what is seen: “no robot”, how far behind the picture is, or for how long nothing has been heard. What is shown after a robot was lost is old, and is shown as old.</source>
        <translation>下の帯には、見ているものがありのままに出ます。「ロボットなし」、表示の遅れ、応答のない時間です。ロボットとの接続が切れた後の表示は古いものなので、古いと示します。</translation>
    </message>
    <message>
        <source>The studio speaks English.</source>
        <translation>表示を英語にします。</translation>
    </message>
    <message>
        <source>The studio speaks Japanese.</source>
        <translation>表示を日本語にします。</translation>
    </message>
    <message>
        <source>The tutorial (Help, Tutorial) draws a robot that measures the blood pressure from nothing in a quarter of an hour.</source>
        <translation>チュートリアル（ヘルプ、チュートリアル）では、血圧を測るロボットを何もないところから 15 分で描きます。</translation>
    </message>
    <message>
        <source>The upper edges come to stand at one height.</source>
        <translation>上端を同じ高さに揃えます。</translation>
    </message>
    <message>
        <source>The values that the robot knows now, by their tags.</source>
        <translation>ロボットが今知っている値をタグごとに。</translation>
    </message>
    <message>
        <source>The whole drawing at once.</source>
        <translation>図の全体を表示。</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>トレース</translation>
    </message>
    <message>
        <source>Values and conditions</source>
        <translation>値と条件</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Welcome page</source>
        <translation>ようこそページ</translation>
    </message>
    <message>
        <source>What a state shows is drawn to scale on the robot&apos;s screen: texts, buttons, images, movies, fields to type into, and lists. A state without a screen keeps the one that was shown before.</source>
        <translation>状態が見せるものを、ロボットの画面と同じ比率で描きます。文字、ボタン、絵、動画、入力欄、一覧です。画面のない状態では、前の画面がそのまま残ります。</translation>
    </message>
    <message>
        <source>What can be added. Drag it onto the drawing, or press it to add it at the selection.</source>
        <translation>追加できるもの。図の上へドラッグするか、押すと選んだところに加わります。</translation>
    </message>
    <message>
        <source>What can not work, and what is probably not meant. A click goes there; a button mends it.</source>
        <translation>動かないところと、おそらく意図と違うところ。クリックでその場所へ、ボタンで直せます。</translation>
    </message>
    <message>
        <source>What is selected as large as there is room for.</source>
        <translation>選んだものをできるだけ大きく表示。</translation>
    </message>
    <message>
        <source>What is spoken, shown and heard, a column for each language.</source>
        <translation>話す・見せる・聞き取る文字を、言語ごとの列で。</translation>
    </message>
    <message>
        <source>What led to it, the input that began it first. A click on a row goes there.</source>
        <translation>経緯を、きっかけの入力から順に。行をクリックするとその時点へ移ります。</translation>
    </message>
    <message>
        <source>What stops the robot from doing what you mean is listed under Problems while you draw. Save with Ctrl+S; what you have not saved yet is kept aside, and offered again after a crash.</source>
        <translation>ロボットが思いどおりに動かない原因は、描いている間、「問題」に並びます。Ctrl+S で保存します。まだ保存していない変更も別に取ってあり、異常終了の後で取り戻せます。</translation>
    </message>
    <message>
        <source>What the robot did, one line each, the latest at the end.</source>
        <translation>ロボットのしたことを一行ずつ、新しいものほど下に。</translation>
    </message>
    <message>
        <source>What the robot says and does</source>
        <translation>ロボットが話し、行うこと</translation>
    </message>
    <message>
        <source>What the robot says is shown with how long it still lasts. With Sound it is heard too, at 1 ×, where espeak-ng is installed.</source>
        <translation>ロボットの発話は、あとどれだけ続くかといっしょに表示されます。espeak-ng が入っていれば、「音声」を入れると 1 × のとき聞くこともできます。</translation>
    </message>
    <message>
        <source>What the shown document has, in its order. A click selects it everywhere.</source>
        <translation>表示中の文書の中身を順に。クリックするとどの表示でも選ばれます。</translation>
    </message>
    <message>
        <source>What was done before is done again, and what shall happen is looked for. A click on what failed shows that moment in all views.</source>
        <translation>前にしたことをもう一度行い、期待したことが起きるか調べます。失敗したものをクリックすると、どの表示もその時点になります。</translation>
    </message>
    <message>
        <source>What was done can be saved as a scenario, with what shall happen again. All of them are run from the panel Scenarios; what they came through can be painted on the drawings.</source>
        <translation>したことは、期待する結果とともにシナリオとして保存できます。「シナリオ」のパネルですべて実行でき、通ったところを図に表示できます。</translation>
    </message>
    <message>
        <source>Where a project is begun or opened. Esc goes back to the one that is open.</source>
        <translation>プロジェクトを始めたり開いたりする場所。Esc で開いているものに戻ります。</translation>
    </message>
    <message>
        <source>Where the robot pauses, and beside it while what. A click goes there, Delete takes one away.</source>
        <translation>ロボットが止まるところと、その条件。クリックでその場所へ、Delete で取り除きます。</translation>
    </message>
    <message>
        <source>Whether a robot is followed, and how old what you see of it is.</source>
        <translation>ロボットを見ているか、見ているものがどれだけ前のものか。</translation>
    </message>
    <message>
        <source>Whether the project&apos;s files have all changes, and since when.</source>
        <translation>変更がすべてファイルに保存されているか、いつからか。</translation>
    </message>
    <message>
        <source>Which module holds which part of the robot, who else asks, and why not they.</source>
        <translation>ロボットのどの部分をどのモジュールが使っているか、ほかに誰が要求しているか、なぜ使えないか。</translation>
    </message>
    <message>
        <source>Which version of the studio this is.</source>
        <translation>このスタジオの版。</translation>
    </message>
    <message>
        <source>While you draw, the project is looked through. An error is something that can not work: a transition to nowhere, two states with one number, an unknown module. A warning is something that is probably not meant: a state that can not be reached, a button that nobody waits for, a speech longer than its timeout.</source>
        <translation>描いている間、プロジェクトが調べられます。エラーは動かないものです。行き先のない遷移、同じ番号の二つの状態、知らないモジュールなどです。警告はおそらく意図と違うものです。たどり着けない状態、誰も待っていないボタン、時間切れより長い発話などです。</translation>
    </message>
    <message>
        <source>Why not? (Shift+F7) shows what kept it from happening at the moment that is seen: an input that did not come, a condition or a guard, a priority, a suspension.</source>
        <translation>「なぜ起きない？」（Shift+F7）は、見ている時点で起きなかった理由を示します。来なかった入力、条件、優先度、一時中断などです。</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>なぜ？</translation>
    </message>
    <message>
        <source>Why? (F7, and the menus of cards, arrows and rows) shows what led to it: one event a row, from the input that began it, with the values then. A click on a row goes to that moment and to the card.</source>
        <translation>「なぜ？」（F7、またはカード・矢印・行のメニュー）は経緯を示します。きっかけの入力から一行に一つずつ、そのときの値とともに並びます。行をクリックすると、その時点とカードへ移ります。</translation>
    </message>
    <message>
        <source>Writes all that was changed into the project&apos;s files.</source>
        <translation>変更をすべてプロジェクトのファイルに書き込みます。</translation>
    </message>
    <message>
        <source>“Stays” keeps a situation for a while, so that the robot is not fickle; “Until” keeps it until something holds; “Ends” ends it at the latest then.</source>
        <translation>「最低継続」は、ロボットが落ち着きなく変わらないように、状況をしばらく保ちます。「終了条件」は、それが成り立つまで保ちます。「終わり」は、遅くともその時間で終わらせます。</translation>
    </message>
</context>
<context>
    <name>kinds</name>
    <message>
        <source>#again once more</source>
        <translation>#again もう一度 繰り返す</translation>
    </message>
    <message>
        <source>#back return</source>
        <translation>#back 戻る</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>A few words for those who draw; the robot does not see them.</source>
        <translation>描く人のための覚え書き。ロボットには見えません。</translation>
    </message>
    <message>
        <source>A field that people type into; what they type goes to a tag.</source>
        <translation>人が入力する欄。入力はタグに入ります。</translation>
    </message>
    <message>
        <source>A film of the media folder, played once.</source>
        <translation>メディアフォルダーの動画。一度再生します。</translation>
    </message>
    <message>
        <source>A picture of the media folder.</source>
        <translation>メディアフォルダーの絵。</translation>
    </message>
    <message>
        <source>A program that moves the robot when it has the authority.</source>
        <translation>実行権を持つときにロボットを動かすプログラム。</translation>
    </message>
    <message>
        <source>A state that runs another application until that ends.</source>
        <translation>別のアプリケーションを、終わるまで動かす状態。</translation>
    </message>
    <message>
        <source>A state; nothing: the state stays, only the actions are done.</source>
        <translation>状態。なければそのままで、動作だけを行います。</translation>
    </message>
    <message>
        <source>A tag that a touch sets, if any.</source>
        <translation>タッチで書き込むタグ（あれば）。</translation>
    </message>
    <message>
        <source>A tag; * stands for one name in it, ** for all below.</source>
        <translation>タグ。* は中の一語、** はそれより下のすべてを表します。</translation>
    </message>
    <message>
        <source>A value on the blackboard that situations look at.</source>
        <translation>状況が見る、ブラックボード上の値。</translation>
    </message>
    <message>
        <source>Actions on entry</source>
        <translation>入ったときの動作</translation>
    </message>
    <message>
        <source>Actions on the way</source>
        <translation>移るときの動作</translation>
    </message>
    <message>
        <source>Add to</source>
        <translation>足す</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Adds a number to the number at a tag; a missing one counts 0.</source>
        <translation>タグの数に数を足します。なければ 0 とみなします。</translation>
    </message>
    <message>
        <source>After</source>
        <translation>待ち時間</translation>
    </message>
    <message>
        <source>After so many seconds without an event the state is left.</source>
        <translation>この秒数イベントがなければ、状態を離れます。</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>揃える</translation>
    </message>
    <message>
        <source>An image of the media folder, or a colour.</source>
        <translation>メディアフォルダーの画像、または色。</translation>
    </message>
    <message>
        <source>Append</source>
        <translation>末尾に加える</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>As in every state</source>
        <translation>共通のものを使う</translation>
    </message>
    <message>
        <source>Asks a web service, a module or a file, and keeps the answer.</source>
        <translation>ウェブサービス、モジュール、ファイルに尋ね、答えを保持します。</translation>
    </message>
    <message>
        <source>At which side of its place the text stands.</source>
        <translation>場所の中で文字をどちらに寄せるか。</translation>
    </message>
    <message>
        <source>Back to the state before</source>
        <translation>前の状態に戻る</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Button</source>
        <translation>ボタン</translation>
    </message>
    <message>
        <source>Choice to</source>
        <translation>選択の書き込み先</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Counted anew after each touch and speech; still while the robot speaks.</source>
        <translation>触れるか話すたびに数え直します。ロボットが話している間は止まります。</translation>
    </message>
    <message>
        <source>DELETE</source>
        <translation>DELETE</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Deletes the tags that fit a pattern: user.** is everything below user.</source>
        <translation>パターンに合うタグを消します。user.** は user の下すべてです。</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Each as</source>
        <translation>項目の見せ方</translation>
    </message>
    <message>
        <source>Empty: taken as soon as its condition holds.</source>
        <translation>空：条件が成り立つとすぐに起こります。</translation>
    </message>
    <message>
        <source>Ending</source>
        <translation>終わり方</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Expected events</source>
        <translation>待つイベント</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗り</translation>
    </message>
    <message>
        <source>Fit for touch and sight</source>
        <translation>触れやすさと見やすさ</translation>
    </message>
    <message>
        <source>For</source>
        <translation>継続</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>From list</source>
        <translation>元の一覧</translation>
    </message>
    <message>
        <source>GET</source>
        <translation>GET</translation>
    </message>
    <message>
        <source>GET asks; the others change something there.</source>
        <translation>GET は尋ねるだけ、ほかは相手側の何かを変えます。</translation>
    </message>
    <message>
        <source>Goes round states that belong together, and moves with them.</source>
        <translation>まとまりのある状態を囲み、一緒に動きます。</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰</translation>
    </message>
    <message>
        <source>H</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Holds when</source>
        <translation>成り立つ条件</translation>
    </message>
    <message>
        <source>How an entry is shown: {item.name}, room {item.room}</source>
        <translation>項目の見せ方：{item.name}、{item.room} 号室</translation>
    </message>
    <message>
        <source>How far from the left.</source>
        <translation>左からの距離。</translation>
    </message>
    <message>
        <source>How far from the top.</source>
        <translation>上からの距離。</translation>
    </message>
    <message>
        <source>How high it is.</source>
        <translation>高さ。</translation>
    </message>
    <message>
        <source>How it is compared.</source>
        <translation>比べ方。</translation>
    </message>
    <message>
        <source>How long the state waits.</source>
        <translation>状態が待つ時間。</translation>
    </message>
    <message>
        <source>How much a module counts in a situation; the highest one that asks wins.</source>
        <translation>状況でのモジュールの重み。要求したうち最も高いものが使います。</translation>
    </message>
    <message>
        <source>How the robot calls it.</source>
        <translation>ロボットでの呼び名。</translation>
    </message>
    <message>
        <source>How traces and results call it.</source>
        <translation>トレースや結果での呼び名。</translation>
    </message>
    <message>
        <source>How wide it is.</source>
        <translation>幅。</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>If it fails</source>
        <translation>失敗したら</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>In every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>In percent of the screen.</source>
        <translation>画面に対する百分率。</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>言葉で</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>入力欄</translation>
    </message>
    <message>
        <source>Is touched, and raises an event.</source>
        <translation>触れるとイベントを起こします。</translation>
    </message>
    <message>
        <source>It has held without a break for so many seconds.</source>
        <translation>この秒数の間、途切れずに成り立っている。</translation>
    </message>
    <message>
        <source>It may end here</source>
        <translation>ここで終わってよい</translation>
    </message>
    <message>
        <source>It runs on when the state is left.</source>
        <translation>状態を離れても続きます。</translation>
    </message>
    <message>
        <source>Its components; those further down lie in front.</source>
        <translation>画面の部品。下にあるものほど手前に重なります。</translation>
    </message>
    <message>
        <source>Its name in traces and scenarios; unique on the screen.</source>
        <translation>トレースとシナリオでの名前。画面の中で一つだけ。</translation>
    </message>
    <message>
        <source>Its name on the robot.</source>
        <translation>ロボットでの名前。</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Launch</source>
        <translation>起動</translation>
    </message>
    <message>
        <source>Leads to</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>List</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最長</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>見た目</translation>
    </message>
    <message>
        <source>May be cut in</source>
        <translation>割り込み可</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>メソッド</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>More is not taken.</source>
        <translation>それ以上は入りません。</translation>
    </message>
    <message>
        <source>Moves one entry of a list to a tag.</source>
        <translation>一覧の一項目をタグに移します。</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name and value of each; {tag} stands for a value on the blackboard.</source>
        <translation>それぞれの名前と値。{tag} はブラックボード上の値になります。</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>必要なもの</translation>
    </message>
    <message>
        <source>New end state</source>
        <translation>新しい終わりの状態</translation>
    </message>
    <message>
        <source>New question with Yes and No</source>
        <translation>はい・いいえでたずねる新しい状態</translation>
    </message>
    <message>
        <source>New state</source>
        <translation>新しい状態</translation>
    </message>
    <message>
        <source>New state that calls a service</source>
        <translation>サービスを呼ぶ新しい状態</translation>
    </message>
    <message>
        <source>New state that moves the robot</source>
        <translation>ロボットを動かす新しい状態</translation>
    </message>
    <message>
        <source>New state that says something</source>
        <translation>話す新しい状態</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Nothing here: it always holds. The last situation must have nothing.</source>
        <translation>なし：いつも成り立ちます。最後の状況は空でなければなりません。</translation>
    </message>
    <message>
        <source>Nothing leads out of this state, and that is meant.</source>
        <translation>この状態から出る道がないのは、そのつもりです。</translation>
    </message>
    <message>
        <source>Nothing: it raises the event timeout, which can be expected.</source>
        <translation>なし：イベント timeout を起こし、それを待てます。</translation>
    </message>
    <message>
        <source>Nothing: the first state.</source>
        <translation>なし：最初の状態。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Of each module in this situation; the higher wins.</source>
        <translation>この状況での各モジュールの優先度。高いほうが使います。</translation>
    </message>
    <message>
        <source>Of exists: true or false.</source>
        <translation>「ある」の場合：true か false。</translation>
    </message>
    <message>
        <source>Of its letters.</source>
        <translation>文字の色。</translation>
    </message>
    <message>
        <source>Of the ground behind it.</source>
        <translation>後ろの地の色。</translation>
    </message>
    <message>
        <source>Of the project&apos;s media folder.</source>
        <translation>プロジェクトのメディアフォルダーのもの。</translation>
    </message>
    <message>
        <source>On the drawing.</source>
        <translation>図の上。</translation>
    </message>
    <message>
        <source>On the screen</source>
        <translation>画面の上</translation>
    </message>
    <message>
        <source>On touch</source>
        <translation>タッチで</translation>
    </message>
    <message>
        <source>Once current it ends then at the latest.</source>
        <translation>この状況になると、遅くともこの時間で終わります。</translation>
    </message>
    <message>
        <source>Once current it holds at least so long.</source>
        <translation>この状況になると、少なくともこの時間は続きます。</translation>
    </message>
    <message>
        <source>Once current it holds until this does.</source>
        <translation>この状況になると、これが成り立つまで続きます。</translation>
    </message>
    <message>
        <source>One test of a value on the blackboard; a situation holds while all of its tests do.</source>
        <translation>ブラックボード上の値を調べます。すべてが成り立つ間、状況は成り立ちます。</translation>
    </message>
    <message>
        <source>Only if</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Only when idle</source>
        <translation>操作のない間だけ</translation>
    </message>
    <message>
        <source>Optional</source>
        <translation>なくてもよいもの</translation>
    </message>
    <message>
        <source>PATCH</source>
        <translation>PATCH</translation>
    </message>
    <message>
        <source>POST</source>
        <translation>POST</translation>
    </message>
    <message>
        <source>PUT</source>
        <translation>PUT</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>Part of the answer</source>
        <translation>答えの部分</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>People may answer while the robot still speaks.</source>
        <translation>ロボットが話している間でも答えられます。</translation>
    </message>
    <message>
        <source>Phrase</source>
        <translation>言葉</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>位置と大きさ</translation>
    </message>
    <message>
        <source>Plays a sound of the media folder.</source>
        <translation>メディアフォルダーの音を鳴らします。</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>赤紫</translation>
    </message>
    <message>
        <source>Priorities</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>Provides</source>
        <translation>提供するもの</translation>
    </message>
    <message>
        <source>Puts a value at the end of the list at a tag.</source>
        <translation>タグの一覧の末尾に値を加えます。</translation>
    </message>
    <message>
        <source>Puts it to an edge or into the middle.</source>
        <translation>端か中央に置きます。</translation>
    </message>
    <message>
        <source>Resource</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>Resources</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>動かすもの</translation>
    </message>
    <message>
        <source>Rust</source>
        <translation>赤茶</translation>
    </message>
    <message>
        <source>Said as</source>
        <translation>言い方</translation>
    </message>
    <message>
        <source>Say again</source>
        <translation>言い直す</translation>
    </message>
    <message>
        <source>Says</source>
        <translation>話すこと</translation>
    </message>
    <message>
        <source>Says the state&apos;s speech once more; only in an event that leads nowhere.</source>
        <translation>状態の発話をもう一度言います。行き先のないイベントでだけ使えます。</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>Sends</source>
        <translation>送るもの</translation>
    </message>
    <message>
        <source>Sends a message to whoever listens to its topic.</source>
        <translation>トピックを聞いているものにメッセージを送ります。</translation>
    </message>
    <message>
        <source>Sent where there are no values.</source>
        <translation>送る値がないときに送られます。</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>サービス</translation>
    </message>
    <message>
        <source>Set value</source>
        <translation>値の設定</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>書き込むもの</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>見せるもの</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>Situations in their order, and the modules&apos; priorities in each.</source>
        <translation>順に並んだ状況と、それぞれでのモジュールの優先度。</translation>
    </message>
    <message>
        <source>Size and colours; by itself they fit the screen.</source>
        <translation>大きさと色。「自動」なら画面に合います。</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Speech</source>
        <translation>発話</translation>
    </message>
    <message>
        <source>Stands at its upper edge.</source>
        <translation>上端に表示されます。</translation>
    </message>
    <message>
        <source>Starts a program that the robot allows.</source>
        <translation>ロボットが許すプログラムを起動します。</translation>
    </message>
    <message>
        <source>Starts with</source>
        <translation>開始状態</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>States and what leads from one to the next.</source>
        <translation>状態と、次へ進むきっかけ。</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>ここにとどまる</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>最低継続</translation>
    </message>
    <message>
        <source>Such as deg or m.</source>
        <translation>deg や m など。</translation>
    </message>
    <message>
        <source>Such as en or ja; empty: the language that the tag language names.</source>
        <translation>en や ja など。空：タグ language の言語。</translation>
    </message>
    <message>
        <source>Such as nurse/call.</source>
        <translation>nurse/call など。</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Take from</source>
        <translation>取り出す</translation>
    </message>
    <message>
        <source>Takes over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>青緑</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>比べ方</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字の大きさ</translation>
    </message>
    <message>
        <source>Text, a number, true or false, a list as JSON; {tag} stands for a value.</source>
        <translation>文字列、数、true か false、JSON の一覧。{tag} は値になります。</translation>
    </message>
    <message>
        <source>The actions after this one start when it has ended, well or badly.</source>
        <translation>続く動作は、これが（成功でも失敗でも）終わってから始まります。</translation>
    </message>
    <message>
        <source>The application&apos;s file. Its ends are the events done.NUMBER, else done.</source>
        <translation>アプリケーションのファイル。終わりはイベント done.番号、または done。</translation>
    </message>
    <message>
        <source>The entries of a list on the blackboard, to choose one.</source>
        <translation>ブラックボードの一覧から一つを選びます。</translation>
    </message>
    <message>
        <source>The entry that is taken; it is in the list no more.</source>
        <translation>取り出される項目。一覧からはなくなります。</translation>
    </message>
    <message>
        <source>The event at Enter, or when it is full.</source>
        <translation>Enter を押すか、いっぱいになったときのイベント。</translation>
    </message>
    <message>
        <source>The event at its end, and where that leads.</source>
        <translation>終わったときのイベントと、その行き先。</translation>
    </message>
    <message>
        <source>The event is taken only while this holds.</source>
        <translation>これが成り立つ間だけイベントが起こります。</translation>
    </message>
    <message>
        <source>The event of a touch on no component.</source>
        <translation>何もないところへのタッチのイベント。</translation>
    </message>
    <message>
        <source>The event that a choice raises.</source>
        <translation>選んだときに起こすイベント。</translation>
    </message>
    <message>
        <source>The event that a touch raises.</source>
        <translation>タッチで起こるイベント。</translation>
    </message>
    <message>
        <source>The event that is raised at its end.</source>
        <translation>終わったときに起こすイベント。</translation>
    </message>
    <message>
        <source>The event that is raised when it has ended badly.</source>
        <translation>失敗して終わったときに起こるイベント。</translation>
    </message>
    <message>
        <source>The event that is raised when it has ended well.</source>
        <translation>成功して終わったときに起こるイベント。</translation>
    </message>
    <message>
        <source>The event that is raised where the robot can not play it.</source>
        <translation>ロボットが再生できないときに起こるイベント。</translation>
    </message>
    <message>
        <source>The event that it raises, and where that leads.</source>
        <translation>起こすイベントと、その行き先。</translation>
    </message>
    <message>
        <source>The higher wins; empty: taken away in this situation.</source>
        <translation>大きいほうが優先。空にすると、この状況では取り上げます。</translation>
    </message>
    <message>
        <source>The robot moves: one of its resources gets a command.</source>
        <translation>ロボットが動きます。リソースの一つに指令を送ります。</translation>
    </message>
    <message>
        <source>The robot says something.</source>
        <translation>ロボットが話します。</translation>
    </message>
    <message>
        <source>The same as a sentence.</source>
        <translation>同じ内容を文で。</translation>
    </message>
    <message>
        <source>The situation whose priorities also count here.</source>
        <translation>ここでも優先度を使う、もとの状況。</translation>
    </message>
    <message>
        <source>The state goes on without it where its resource is taken by another module.</source>
        <translation>リソースを別のモジュールが使っていれば、これなしで進みます。</translation>
    </message>
    <message>
        <source>The tag at which the list stands.</source>
        <translation>一覧のあるタグ。</translation>
    </message>
    <message>
        <source>The tag that gets the entry.</source>
        <translation>項目を受け取るタグ。</translation>
    </message>
    <message>
        <source>The tag that gets what is typed.</source>
        <translation>入力を受け取るタグ。</translation>
    </message>
    <message>
        <source>The tag was set less than so many seconds ago.</source>
        <translation>タグに書き込まれてから、この秒数より経っていない。</translation>
    </message>
    <message>
        <source>The text&apos;s height in percent of the screen&apos;s.</source>
        <translation>文字の高さ（画面の高さに対する %）。</translation>
    </message>
    <message>
        <source>The usual</source>
        <translation>いつもの</translation>
    </message>
    <message>
        <source>The value that the tag gets.</source>
        <translation>タグが受け取る値。</translation>
    </message>
    <message>
        <source>The values that it reads.</source>
        <translation>読む値。</translation>
    </message>
    <message>
        <source>The values that it writes.</source>
        <translation>書き込む値。</translation>
    </message>
    <message>
        <source>This state again</source>
        <translation>この状態をもう一度</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>題名</translation>
    </message>
    <message>
        <source>To</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>To tell it from others at a glance.</source>
        <translation>一目で見分けるため。</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Unique; others call it so.</source>
        <translation>重ならない名前。ほかからこの名前で呼ばれます。</translation>
    </message>
    <message>
        <source>Unique; transitions lead to it.</source>
        <translation>重複しない番号。遷移の行き先になります。</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>終了条件</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Values sent</source>
        <translation>送る値</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>W</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Wait for it</source>
        <translation>終わるまで待つ</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>What happens when it has ended.</source>
        <translation>終わったときに起こること。</translation>
    </message>
    <message>
        <source>What happens when nothing happens.</source>
        <translation>何も起こらないときにどうなるか。</translation>
    </message>
    <message>
        <source>What is done before the next state is entered.</source>
        <translation>次の状態に入る前に行うこと。</translation>
    </message>
    <message>
        <source>What is going on, and who may use the robot then.</source>
        <translation>何が起きているか、そのとき誰がロボットを使えるか。</translation>
    </message>
    <message>
        <source>What is part of every state: a Home button, a timeout, what people may say at any time.</source>
        <translation>すべての状態に共通のもの：ホームボタン、時間切れ、いつでも言える言葉。</translation>
    </message>
    <message>
        <source>What is seldom needed.</source>
        <translation>めったに使わないもの。</translation>
    </message>
    <message>
        <source>What is to be remembered about it; the robot does not see it.</source>
        <translation>覚えておきたいこと。ロボットには見えません。</translation>
    </message>
    <message>
        <source>What is waited for, and where each leads.</source>
        <translation>待つものと、それぞれの行き先。</translation>
    </message>
    <message>
        <source>What it is for, in a sentence or two.</source>
        <translation>何のためのものか、一、二文で。</translation>
    </message>
    <message>
        <source>What it may ask for, such as: head base</source>
        <translation>求めてよいもの（例：head base）</translation>
    </message>
    <message>
        <source>What it says.</source>
        <translation>話す内容。</translation>
    </message>
    <message>
        <source>What its developer says of a module.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What its values are.</source>
        <translation>どんな値か。</translation>
    </message>
    <message>
        <source>What moves: base, head …</source>
        <translation>動くもの：base、head など</translation>
    </message>
    <message>
        <source>What old fingers and eyes need, on a screen of 10 inches.</source>
        <translation>10 インチの画面で、お年寄りの指と目に必要なこと。</translation>
    </message>
    <message>
        <source>What people may say instead.</source>
        <translation>代わりに人が言える言葉。</translation>
    </message>
    <message>
        <source>What stands on it.</source>
        <translation>上に出る文字。</translation>
    </message>
    <message>
        <source>What the developers of the modules say of them.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What the robot says and does when the state is entered.</source>
        <translation>状態に入ったときにロボットが話し、行うこと。</translation>
    </message>
    <message>
        <source>What the robot shows, says and waits for.</source>
        <translation>ロボットが見せ、話し、待つもの。</translation>
    </message>
    <message>
        <source>What the robot shows, until another screen comes.</source>
        <translation>次の画面が出るまでロボットが見せるもの。</translation>
    </message>
    <message>
        <source>What the robot shows. Without one, what was shown before stays.</source>
        <translation>ロボットが見せるもの。なければ前の画面が残ります。</translation>
    </message>
    <message>
        <source>What the robot&apos;s adapter knows, such as goto.</source>
        <translation>ロボットのアダプターが知る指令（goto など）。</translation>
    </message>
    <message>
        <source>What the state waits for, and where it leads.</source>
        <translation>状態が待つものと、その行き先。</translation>
    </message>
    <message>
        <source>What you call it; a few words will do.</source>
        <translation>呼び名。短い言葉で十分です。</translation>
    </message>
    <message>
        <source>What “In every state” adds is part of this one too.</source>
        <translation>「すべての状態」のものがここにも加わります。</translation>
    </message>
    <message>
        <source>When done</source>
        <translation>完了したら</translation>
    </message>
    <message>
        <source>When touched</source>
        <translation>触れたとき</translation>
    </message>
    <message>
        <source>Where the value stands on the blackboard, such as user.name.</source>
        <translation>ブラックボード上で値のある場所（user.name など）。</translation>
    </message>
    <message>
        <source>Which</source>
        <translation>どれを</translation>
    </message>
    <message>
        <source>Which keys the robot offers.</source>
        <translation>ロボットが出すキー。</translation>
    </message>
    <message>
        <source>Which part of the answer goes to which tag.</source>
        <translation>答えのどの部分をどのタグに書き込むか。</translation>
    </message>
    <message>
        <source>Whose priority it is.</source>
        <translation>誰の優先度か。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>以内</translation>
    </message>
    <message>
        <source>Words on the screen.</source>
        <translation>画面の文字。</translation>
    </message>
    <message>
        <source>Writes a value on the blackboard.</source>
        <translation>ブラックボードに値を書き込みます。</translation>
    </message>
    <message>
        <source>Writes to</source>
        <translation>書き込み先</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>a PIN</source>
        <translation>暗証番号</translation>
    </message>
    <message>
        <source>a date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a random one</source>
        <translation>無作為に一つ</translation>
    </message>
    <message>
        <source>above</source>
        <translation>より大きい</translation>
    </message>
    <message>
        <source>all of these</source>
        <translation>すべて成り立つ</translation>
    </message>
    <message>
        <source>any of these</source>
        <translation>どれかが成り立つ</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>設定のまま</translation>
    </message>
    <message>
        <source>ask buttons screen</source>
        <translation>質問 ボタン 画面</translation>
    </message>
    <message>
        <source>at 10 inches</source>
        <translation>10 インチで</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>以上</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>以下</translation>
    </message>
    <message>
        <source>back to front</source>
        <translation>奥から手前へ</translation>
    </message>
    <message>
        <source>below</source>
        <translation>より小さい</translation>
    </message>
    <message>
        <source>by itself</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>characters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>datum</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>drive head go</source>
        <translation>移動 頭 行く</translation>
    </message>
    <message>
        <source>empty card</source>
        <translation>空のカード</translation>
    </message>
    <message>
        <source>exists</source>
        <translation>ある</translation>
    </message>
    <message>
        <source>finish stop final</source>
        <translation>終わり 停止</translation>
    </message>
    <message>
        <source>http://…, board:module/request, or media:file.json</source>
        <translation>http://…、board:モジュール/要求、media:ファイル.json</translation>
    </message>
    <message>
        <source>is</source>
        <translation>である</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>がありません</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>ではない</translation>
    </message>
    <message>
        <source>is one of</source>
        <translation>のどれか</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>list</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>need</source>
        <translation>必要なもの</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>none of these</source>
        <translation>どれも成り立たない</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>nothing internal disconnect</source>
        <translation>何もしない 内部 切り離す</translation>
    </message>
    <message>
        <source>number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>画面で</translation>
    </message>
    <message>
        <source>or module</source>
        <translation>またはモジュール</translation>
    </message>
    <message>
        <source>phrase</source>
        <translation>言葉</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>無地</translation>
    </message>
    <message>
        <source>result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>s</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>s at least</source>
        <translation>秒以上</translation>
    </message>
    <message>
        <source>s at most</source>
        <translation>秒以内</translation>
    </message>
    <message>
        <source>speech talk voice</source>
        <translation>発話 話す 声</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>the first state</source>
        <translation>最初の状態</translation>
    </message>
    <message>
        <source>the first that fits</source>
        <translation>最初に合うもの</translation>
    </message>
    <message>
        <source>value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>web request</source>
        <translation>ウェブ 問い合わせ</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>はい／いいえ</translation>
    </message>
    <message>
        <source>{tag} stands for a value on the blackboard and follows its changes.</source>
        <translation>{tag} はブラックボード上の値になり、変わると追従します。</translation>
    </message>
    <message>
        <source>{tag} stands for a value on the blackboard: Hello {user.name}</source>
        <translation>{tag} はブラックボード上の値になります：こんにちは、{user.name}さん</translation>
    </message>
</context>
<context>
    <name>runtime</name>
    <message>
        <source> (and {0} more: situ check {1})</source>
        <translation>（ほかに {0} 件：situ check {1}）</translation>
    </message>
    <message>
        <source> (used {0} times here)</source>
        <translation>（ここで {0} 回使用）</translation>
    </message>
    <message>
        <source> and </source>
        <translation>と</translation>
    </message>
    <message>
        <source> and {0} more</source>
        <translation>ほか {0} 件</translation>
    </message>
    <message>
        <source> or </source>
        <translation>または</translation>
    </message>
    <message>
        <source> → </source>
        <translation> → </translation>
    </message>
    <message>
        <source>&quot;{0}&quot; and &quot;{1}&quot; both have the priority {2} in &quot;{3}&quot; and can ask for {4}: who asked first would win; give one of them another priority</source>
        <translation>「{3}」では “{0}” と “{1}” の優先度がどちらも {2} で、どちらも {4} を求めることができます。このままでは先に求めたほうが勝ちます。どちらかの優先度を変えてください</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>, goes before {0}</source>
        <translation>、{0} より先</translation>
    </message>
    <message>
        <source>, leads to {0}</source>
        <translation>、行き先は {0}</translation>
    </message>
    <message>
        <source>, or observe it in the script</source>
        <translation>、またはスクリプトで観測する</translation>
    </message>
    <message>
        <source>, when {0}</source>
        <translation>、{0} のとき</translation>
    </message>
    <message>
        <source>, {0} the part {1}</source>
        <translation>、部品 {1} を {0}</translation>
    </message>
    <message>
        <source>--not needs an “application” of {0}</source>
        <translation>「アプリケーション」を {0} から指定してください</translation>
    </message>
    <message>
        <source>--not of kind {0} needs “{1}”</source>
        <translation>種類 {0} には「{1}」が必要です</translation>
    </message>
    <message>
        <source>--not wants a “kind” of {0}, not {1}</source>
        <translation>種類は {0} のどれかです。{1} ではありません</translation>
    </message>
    <message>
        <source>--not: {0} has no state {1}</source>
        <translation>{0} に状態 {1} はありません</translation>
    </message>
    <message>
        <source>: </source>
        <translation>：</translation>
    </message>
    <message>
        <source>: add xmlns:ed=&quot;{0}&quot; to the first element</source>
        <translation>：最初の要素に xmlns:ed=&quot;{0}&quot; を加えてください</translation>
    </message>
    <message>
        <source>: nothing can stand in it</source>
        <translation>：ここには何も置けません</translation>
    </message>
    <message>
        <source>; </source>
        <translation>。</translation>
    </message>
    <message>
        <source>; did you mean &quot;{0}&quot;?</source>
        <translation>。“{0}” のことですか？</translation>
    </message>
    <message>
        <source>; did you mean &lt;{0}&gt;?</source>
        <translation>。&lt;{0}&gt; のことですか？</translation>
    </message>
    <message>
        <source>; the states are {0}{1}</source>
        <translation>。状態は {0}{1} です</translation>
    </message>
    <message>
        <source>&lt;?xml …?&gt; may stand only at the very beginning: take out what is before it</source>
        <translation>&lt;?xml …?&gt; はファイルの先頭にだけ置けます。その前にあるものを取り除いてください</translation>
    </message>
    <message>
        <source>&lt;data&gt; has {0} tests ({1}): write one &lt;data&gt; for each</source>
        <translation>&lt;data&gt; に {0} 個のテスト（{1}）があります。テストごとに &lt;data&gt; を分けてください</translation>
    </message>
    <message>
        <source>&lt;data&gt; tests nothing: add one of {0}</source>
        <translation>&lt;data&gt; が何もテストしていません。{0} のどれかを加えてください</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; has no attribute &quot;{1}&quot;</source>
        <translation>&lt;{0}&gt; に属性 &quot;{1}&quot; はありません</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; has no place in &lt;{1}&gt;: it belongs in &lt;{2}&gt;</source>
        <translation>&lt;{0}&gt; は &lt;{1}&gt; には置けません。&lt;{2}&gt; に置いてください</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; holds two &lt;{1}&gt;: only one may stand here</source>
        <translation>&lt;{0}&gt; に &lt;{1}&gt; が二つあります。一つだけにしてください</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; is empty: write a number</source>
        <translation>&lt;{0}&gt; が空です。数を書いてください</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; is no document of Situ</source>
        <translation>&lt;{0}&gt; は Situ の文書ではありません</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; is not known in &lt;{1}&gt;</source>
        <translation>&lt;{0}&gt; は &lt;{1}&gt; の中では使えません</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; must have no namespace: take the xmlns attribute out</source>
        <translation>&lt;{0}&gt; に名前空間は付けられません。xmlns 属性を取り除いてください</translation>
    </message>
    <message>
        <source>&lt;{0}&gt; needs the attribute &quot;{1}&quot;: add {2}=&quot;…&quot;</source>
        <translation>&lt;{0}&gt; には属性 &quot;{1}&quot; が必要です。{2}=&quot;…&quot; を加えてください</translation>
    </message>
    <message>
        <source>A DOCTYPE is not allowed: take it out</source>
        <translation>DOCTYPE は使えません。取り除いてください</translation>
    </message>
    <message>
        <source>A NUL character stands here: no XML file may hold one</source>
        <translation>ここに NUL 文字があります。XML ファイルには置けません</translation>
    </message>
    <message>
        <source>A choice needs choices = [&quot;a&quot;, &quot;b&quot;]: two texts or more, each once</source>
        <translation>choice には choices = [&quot;a&quot;, &quot;b&quot;] のように、異なる文字列が二つ以上必要です</translation>
    </message>
    <message>
        <source>A part begins in one state, but ways from outside lead to {0}: select more or fewer states, or lead them all to one.</source>
        <translation>部品は一つの状態から始まりますが、外からの矢印が {0} に入っています。選ぶ状態を増やすか減らすか、矢印を一つの状態にまとめてください。</translation>
    </message>
    <message>
        <source>A script cannot compare with a reference: {0}; write the value itself</source>
        <translation>スクリプトでは参照 {0} と比べられません。値そのものを書いてください</translation>
    </message>
    <message>
        <source>A touch on this screen</source>
        <translation>この画面へのタッチ</translation>
    </message>
    <message>
        <source>Accept this warning</source>
        <translation>この警告を認める</translation>
    </message>
    <message>
        <source>Add a state</source>
        <translation>状態を追加</translation>
    </message>
    <message>
        <source>Add the situation {0}, which always holds</source>
        <translation>いつも成り立つ状況 {0} を加える</translation>
    </message>
    <message>
        <source>Add {0} to the languages</source>
        <translation>{0} を言語に加える</translation>
    </message>
    <message>
        <source>Ask that {0} exists</source>
        <translation>{0} があることを条件にする</translation>
    </message>
    <message>
        <source>Ask {0} instead</source>
        <translation>代わりに {0} に頼む</translation>
    </message>
    <message>
        <source>Begin with a situation that holds while {0} is true</source>
        <translation>{0} が真の間に成り立つ状況から始める</translation>
    </message>
    <message>
        <source>Call it {0}</source>
        <translation>{0} という名前にする</translation>
    </message>
    <message>
        <source>Choices are for the type &quot;choice&quot;, not {0}</source>
        <translation>choices は &quot;choice&quot; 型のためのもので、{0} には使えません</translation>
    </message>
    <message>
        <source>Declare {0} with {1}</source>
        <translation>{0} に {1} を宣言する</translation>
    </message>
    <message>
        <source>Elements stand more than {0} deep in each other: close some before</source>
        <translation>要素の入れ子が {0} 段を超えています。先にどれかを閉じてください</translation>
    </message>
    <message>
        <source>Every state expects {0}, which the end {1} of the part would be: leave it out of the selection.</source>
        <translation>すべての状態が {0} を待っていますが、部品の終わり {1} がそれになってしまいます。選択から外してください。</translation>
    </message>
    <message>
        <source>Expect {0} in {1}</source>
        <translation>{1} で {0} を待つ</translation>
    </message>
    <message>
        <source>Extend {0}</source>
        <translation>{0} を引き継ぐ</translation>
    </message>
    <message>
        <source>Give it the number {0}</source>
        <translation>番号を {0} にする</translation>
    </message>
    <message>
        <source>Give it the priority {0} in {1}</source>
        <translation>{1} での優先度を {0} にする</translation>
    </message>
    <message>
        <source>Give it {0}</source>
        <translation>{0} にする</translation>
    </message>
    <message>
        <source>Give {0} the priority {1} in {2}</source>
        <translation>{2} で {0} の優先度を {1} にする</translation>
    </message>
    <message>
        <source>Go to the start {0} s after the last touch</source>
        <translation>最後のタッチから {0} 秒後に最初へ戻る</translation>
    </message>
    <message>
        <source>In {0} {1} leads to {2}, which would be another state then: lead it to a state first.</source>
        <translation>{0} の {1} の行き先は {2} ですが、それでは別の状態になります。先に行き先の状態を決めてください。</translation>
    </message>
    <message>
        <source>It is not known {0}: finding out would have taken too long; make the conditions simpler, or try it out with situ simulate</source>
        <translation>{0} は分かりません。調べるには時間がかかりすぎます。条件を簡単にするか、situ simulate で試してください</translation>
    </message>
    <message>
        <source>Lead to state {0}</source>
        <translation>行き先を状態 {0} にする</translation>
    </message>
    <message>
        <source>Let any text be put in</source>
        <translation>どんな文でも入れられるようにする</translation>
    </message>
    <message>
        <source>Let it always hold</source>
        <translation>いつも成り立つようにする</translation>
    </message>
    <message>
        <source>Let the timeout count from the end of the speech</source>
        <translation>時間切れを発話の終わりから数える</translation>
    </message>
    <message>
        <source>Make it a choice</source>
        <translation>選択式にする</translation>
    </message>
    <message>
        <source>Make it a list</source>
        <translation>一覧にする</translation>
    </message>
    <message>
        <source>Make it a {0}</source>
        <translation>{0} にする</translation>
    </message>
    <message>
        <source>Make it the event {0}</source>
        <translation>イベント {0} にする</translation>
    </message>
    <message>
        <source>Make it {0} mm large</source>
        <translation>大きさを {0} mm にする</translation>
    </message>
    <message>
        <source>Make the color {0}</source>
        <translation>色を {0} にする</translation>
    </message>
    <message>
        <source>Make the size {0}</source>
        <translation>大きさを {0} にする</translation>
    </message>
    <message>
        <source>Move it to state {0}</source>
        <translation>状態 {0} に移す</translation>
    </message>
    <message>
        <source>Move {0} in</source>
        <translation>{0} を中に移す</translation>
    </message>
    <message>
        <source>Name each once</source>
        <translation>一つずつにする</translation>
    </message>
    <message>
        <source>No module {0} is declared, so this service always fails: {1}</source>
        <translation>モジュール {0} は宣言されていないので、このサービスは必ず失敗します：{1}</translation>
    </message>
    <message>
        <source>No setting is a {0}; did you mean {1}? There are {2}</source>
        <translation>{0} という設定はありません。{1} のことですか？ あるのは {2} です</translation>
    </message>
    <message>
        <source>Nobody writes {0}{1}, so it never has a value: {2}</source>
        <translation>{0}{1} に書き込むものがないので、値を持つことがありません：{2}</translation>
    </message>
    <message>
        <source>Nothing stops this robot ({0} may move it): begin with a situation, without a limit, that gives no priority to what moves it and holds while somebody says stop</source>
        <translation>このロボットを止めるものがありません（{0} が動かすことがあります）。誰かが「止まれ」と言っている間に成り立ち、動かすモジュールに優先度を与えず、期限のない状況を最初に置いてください</translation>
    </message>
    <message>
        <source>Nothing stops this robot once it moves ({0}): write a script whose first situation gives nobody a priority while somebody says stop</source>
        <translation>動き出したロボットを止めるものがありません（{0}）。誰かが「止まれ」と言っている間、どのモジュールにも優先度を与えない状況で始まるスクリプトを書いてください</translation>
    </message>
    <message>
        <source>Observe {0}</source>
        <translation>{0} を観測する</translation>
    </message>
    <message>
        <source>Observe {0}: a module writes it</source>
        <translation>{0} を観測する（モジュールが書き込みます）</translation>
    </message>
    <message>
        <source>Offer each choice once</source>
        <translation>それぞれの選択肢を一度だけ出す</translation>
    </message>
    <message>
        <source>Only &amp;amp; &amp;lt; &amp;gt; &amp;quot; &amp;apos; and numbers such as &amp;#233; may follow &amp;</source>
        <translation>&amp; の後には &amp;amp; &amp;lt; &amp;gt; &amp;quot; &amp;apos; か &amp;#233; のような番号だけを書けます</translation>
    </message>
    <message>
        <source>Put it before event {0}</source>
        <translation>イベント {0} の前に置く</translation>
    </message>
    <message>
        <source>Put it before {0}</source>
        <translation>{0} の前に置く</translation>
    </message>
    <message>
        <source>Put {0} beneath {1}</source>
        <translation>{0} を {1} の下に置く</translation>
    </message>
    <message>
        <source>Raise {0} instead</source>
        <translation>代わりに {0} を起こす</translation>
    </message>
    <message>
        <source>Read {0} instead</source>
        <translation>代わりに {0} を読む</translation>
    </message>
    <message>
        <source>Rename it to {0}</source>
        <translation>名前を {0} に変える</translation>
    </message>
    <message>
        <source>Require {0} instead</source>
        <translation>代わりに {0} を必要とする</translation>
    </message>
    <message>
        <source>Say here what {0} says</source>
        <translation>{0} の言うことをここで言う</translation>
    </message>
    <message>
        <source>Say that it is meant to be the end</source>
        <translation>ここが終わりだと示す</translation>
    </message>
    <message>
        <source>Select a state that runs a part first.</source>
        <translation>先に、部品を動かす状態を選んでください。</translation>
    </message>
    <message>
        <source>Select the states that the part shall have first.</source>
        <translation>先に、部品にする状態を選んでください。</translation>
    </message>
    <message>
        <source>So that {0} fits into it, the letters become {1} mm or less on a 10-inch screen, too small for many old eyes: make it larger, or say less</source>
        <translation>{0} を収めるには文字が 10 インチの画面で {1} mm 以下になり、高齢の方の多くには小さすぎます。大きくするか、言葉を短くしてください</translation>
    </message>
    <message>
        <source>Something stands behind the end of the document: take it out, or move it inside</source>
        <translation>文書の終わりの後に何かがあります。取り除くか、中に移してください</translation>
    </message>
    <message>
        <source>Something stands here that XML does not allow: write &amp;lt; for &lt; and &amp;amp; for &amp; in texts, and look for a quote or a &gt; that is missing before</source>
        <translation>ここに XML で許されないものがあります。文章の中では &lt; を &amp;lt;、&amp; を &amp;amp; と書き、前に抜けている引用符や &gt; がないか確かめてください</translation>
    </message>
    <message>
        <source>Start in state {0}</source>
        <translation>状態 {0} から始める</translation>
    </message>
    <message>
        <source>Take dwell out</source>
        <translation>dwell を取り除く</translation>
    </message>
    <message>
        <source>Take extends out</source>
        <translation>extends を取り除く</translation>
    </message>
    <message>
        <source>Take extends out here</source>
        <translation>ここの extends を取り除く</translation>
    </message>
    <message>
        <source>Take it out</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Take out what is accepted in vain</source>
        <translation>無用な承認を取り除く</translation>
    </message>
    <message>
        <source>Take the text out</source>
        <translation>本文を取り除く</translation>
    </message>
    <message>
        <source>Take this one out</source>
        <translation>これを取り除く</translation>
    </message>
    <message>
        <source>Take {0} out</source>
        <translation>{0} を取り除く</translation>
    </message>
    <message>
        <source>Text cannot stand directly in &lt;{0}&gt;: {1}; put it into an element that holds text, such as &lt;speech&gt;, or into a comment &lt;!-- … --&gt;</source>
        <translation>&lt;{0}&gt; に文章を直接置くことはできません：{1}。&lt;speech&gt; のような文章のための要素か、コメント &lt;!-- … --&gt; に入れてください</translation>
    </message>
    <message>
        <source>The XML is broken here: {0}</source>
        <translation>ここで XML が壊れています：{0}</translation>
    </message>
    <message>
        <source>The application starts in state {0}, which does not exist{1}</source>
        <translation>アプリケーションは状態 {0} から始まりますが、その状態はありません{1}</translation>
    </message>
    <message>
        <source>The call {0} may wait: {1}, and then nothing is sent; send it (too) from an application that uses neither screen nor speech nor robot</source>
        <translation>呼び出し {0} は待たされることがあり（{1}）、その間は何も送られません。画面も発話もロボットも使わないアプリケーションから（も）送ってください</translation>
    </message>
    <message>
        <source>The color {0} on {1} is hard to read: their contrast is {2}, and {3} is needed; choose a darker or a lighter color</source>
        <translation>{1} の上の色 {0} は読みにくい配色です。コントラストは {2} ですが {3} 必要です。もっと濃い色か薄い色を選んでください</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}</source>
        <translation>ファイルを読めません：{0}</translation>
    </message>
    <message>
        <source>The file ends inside &lt;{0}&gt;: its end tag is missing</source>
        <translation>ファイルが &lt;{0}&gt; の途中で終わっています。終了タグがありません</translation>
    </message>
    <message>
        <source>The file holds more than {0} elements: split it into parts</source>
        <translation>ファイルの要素が {0} 個を超えています。部品に分けてください</translation>
    </message>
    <message>
        <source>The file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>The file is larger than {0} MB</source>
        <translation>ファイルが {0} MB を超えています</translation>
    </message>
    <message>
        <source>The file is larger than {0} MB: split it into parts</source>
        <translation>ファイルが {0} MB を超えています。部品に分けてください</translation>
    </message>
    <message>
        <source>The file is not UTF-8 here: save it as UTF-8</source>
        <translation>ここは UTF-8 ではありません。UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>The file says that it is {0}: save it as UTF-8</source>
        <translation>ファイルは {0} だとされています。UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>The last situation must always hold: take its until and limit out</source>
        <translation>最後の状況はいつも成り立たなければなりません。until と limit を取り除いてください</translation>
    </message>
    <message>
        <source>The module &quot;{0}&quot; can never hold authority: {1}; raise its priority, or give it a situation of its own</source>
        <translation>モジュール “{0}” は実行権を持つことがありません：{1}。優先度を上げるか、専用の状況を設けてください</translation>
    </message>
    <message>
        <source>The module &quot;{0}&quot; has no resources, so its priority has no effect: take it out</source>
        <translation>モジュール “{0}” にはリソースがないので、優先度に意味がありません。取り除いてください</translation>
    </message>
    <message>
        <source>The part {0} leads back to this file ({1}), and a part cannot hold itself: let it end, and lead on from its done event</source>
        <translation>部品 {0} はこのファイルに戻ってきます（{1}）。部品は自分自身を含めません。部品を終わらせ、その done イベントから先へ進めてください</translation>
    </message>
    <message>
        <source>The part {0} leads out of the project: its files lie in its folder</source>
        <translation>部品 {0} がプロジェクトの外にあります。ファイルはプロジェクトのフォルダーに置きます</translation>
    </message>
    <message>
        <source>The place {0} {1}</source>
        <translation>場所 {0} {1}</translation>
    </message>
    <message>
        <source>The prefix &quot;{0}&quot; is not declared</source>
        <translation>接頭辞 &quot;{0}&quot; が宣言されていません</translation>
    </message>
    <message>
        <source>The same attribute stands twice in this tag: take one out</source>
        <translation>このタグに同じ属性が二つあります。一つを取り除いてください</translation>
    </message>
    <message>
        <source>The state {0} can begin again and again</source>
        <translation>状態 {0} が何度でも始まり直すことがあります</translation>
    </message>
    <message>
        <source>The state {0} cannot be reached: {1}; connect it, or take it out</source>
        <translation>状態 {0} にはたどり着けません：{1}。つなぐか、取り除いてください</translation>
    </message>
    <message>
        <source>The states {0} can lead to each other for ever</source>
        <translation>状態 {0} が互いに終わりなく移り続けることがあります</translation>
    </message>
    <message>
        <source>The text of &lt;{0}&gt; is too long: {1}</source>
        <translation>&lt;{0}&gt; の文章が長すぎます：{1}</translation>
    </message>
    <message>
        <source>The text of &lt;{0}&gt; {1}</source>
        <translation>&lt;{0}&gt; の文章 {1}</translation>
    </message>
    <message>
        <source>The timeout of {0} ends the part, and {1} does something on the way, which a timeout can not: let that state do it first.</source>
        <translation>{0} の時間切れで部品が終わりますが、{1} が移るときに行う動作は時間切れではできません。先にその状態の動作にしてください。</translation>
    </message>
    <message>
        <source>The url {0} stand in the robot&apos;s secrets.toml</source>
        <translation>ロボットの secrets.toml にある URL {0}</translation>
    </message>
    <message>
        <source>The {0} leads to state {1}, which does not exist{2}</source>
        <translation>{0} の行き先の状態 {1} はありません{2}</translation>
    </message>
    <message>
        <source>The {0} of &lt;{1}&gt;</source>
        <translation>&lt;{1}&gt; の {0}</translation>
    </message>
    <message>
        <source>The {0} of &lt;{1}&gt; is too long: {2}</source>
        <translation>&lt;{1}&gt; の {0} が長すぎます：{2}</translation>
    </message>
    <message>
        <source>The {0} of &lt;{1}&gt; {2}</source>
        <translation>&lt;{1}&gt; の {0} {2}</translation>
    </message>
    <message>
        <source>The {0} of this {1}</source>
        <translation>この{1}の {0}</translation>
    </message>
    <message>
        <source>The {0} {1}</source>
        <translation>{0} {1}</translation>
    </message>
    <message>
        <source>There are no files: give the texts of a project, its {0} among them</source>
        <translation>ファイルがありません。プロジェクトの文書を、{0} も含めて渡してください</translation>
    </message>
    <message>
        <source>There are no texts in {0}, all stay as they are written: add it to the languages of situ.toml, or choose {1}</source>
        <translation>{0} の訳はなく、すべて書かれたまま使われます。situ.toml の言語に加えるか、{1} を選んでください</translation>
    </message>
    <message>
        <source>There are two components {0} {1}: rename one</source>
        <translation>{0} という画面要素が{1}二つあります。一方の名前を変えてください</translation>
    </message>
    <message>
        <source>There are two modules {0}: give one of them another name</source>
        <translation>モジュール {0} が二つあります。一方に別の名前を付けてください</translation>
    </message>
    <message>
        <source>There are two situations {0}: give one another name</source>
        <translation>状況 {0} が二つあります。一方に別の名前を付けてください</translation>
    </message>
    <message>
        <source>There are two states {0}: give this one another no</source>
        <translation>状態 {0} が二つあります。一方に別の番号を付けてください</translation>
    </message>
    <message>
        <source>There is no file {0} for this part: add it, or name another</source>
        <translation>この部品のファイル {0} がありません。加えるか、別のものを指定してください</translation>
    </message>
    <message>
        <source>There is no file {0} {1}: add it, or name another</source>
        <translation>ファイル {0} が{1}ありません。加えるか、別のものを指定してください</translation>
    </message>
    <message>
        <source>There is no file {0}: add it, or take it out here</source>
        <translation>ファイル {0} がありません。加えるか、ここから取り除いてください</translation>
    </message>
    <message>
        <source>These letters are {0} mm on a 10-inch screen, too small for many old eyes: make the size at least {1}</source>
        <translation>この文字は 10 インチの画面で {0} mm で、高齢の方の多くには小さすぎます。大きさを {1} 以上にしてください</translation>
    </message>
    <message>
        <source>This &lt; is never closed: finish the tag with &gt;</source>
        <translation>この &lt; が閉じていません。タグを &gt; で終えてください</translation>
    </message>
    <message>
        <source>This &lt;![CDATA[ is never closed: finish it with ]]&gt;</source>
        <translation>この &lt;![CDATA[ が閉じていません。]]&gt; で終えてください</translation>
    </message>
    <message>
        <source>This can never hold ({0}), {1}: change or take out one of them</source>
        <translation>これは成り立つことがありません（{0}）、{1}。どちらかを変えるか取り除いてください</translation>
    </message>
    <message>
        <source>This end tag does not fit: &lt;{0}&gt; is still open</source>
        <translation>この終了タグは合いません。&lt;{0}&gt; がまだ開いています</translation>
    </message>
    <message>
        <source>This is no TOML here: {0}</source>
        <translation>ここは TOML として読めません：{0}</translation>
    </message>
    <message>
        <source>This is no TOML: {0}</source>
        <translation>TOML として読めません：{0}</translation>
    </message>
    <message>
        <source>This is {0} mm {1} on a 10-inch screen, and fingers need {2}: make it at least {3} wide and {4} high</source>
        <translation>10 インチの画面で{1}が {0} mm ですが、指には {2} mm 必要です。幅を {3} 以上、高さを {4} 以上にしてください</translation>
    </message>
    <message>
        <source>This line is none of a .po file: write msgid &quot;…&quot; and msgstr &quot;…&quot;</source>
        <translation>この行は .po ファイルのものではありません。msgid &quot;…&quot; と msgstr &quot;…&quot; を書いてください</translation>
    </message>
    <message>
        <source>This shows {0}, which is private, until a hand takes it away, to anyone who comes after: add a timeout that leads to the start</source>
        <translation>個人情報の {0} が、誰かが触れるまで後から来た人にも見えたままになります。最初に戻る時間切れを加えてください</translation>
    </message>
    <message>
        <source>This situation extends {0}, which does not exist: name one that there is, or take extends out</source>
        <translation>この状況は {0} を引き継ぎますが、それはありません。ある状況を指定するか、extends を取り除いてください</translation>
    </message>
    <message>
        <source>This situation is never current: whenever it could begin, {0} above it {1}; move it up, or change a condition</source>
        <translation>この状況になることはありません。始まれるときには必ず、上にある {0} が {1} からです。上に移すか、条件を変えてください</translation>
    </message>
    <message>
        <source>This situation never begins: whenever its condition holds, so does its until; change one of them</source>
        <translation>この状況は始まりません。条件が成り立つときには必ず until も成り立ちます。どちらかを変えてください</translation>
    </message>
    <message>
        <source>This timeout never runs out</source>
        <translation>この時間切れは起こりません</translation>
    </message>
    <message>
        <source>This {0}</source>
        <translation>この{0}</translation>
    </message>
    <message>
        <source>This {0} is never taken</source>
        <translation>この{0}は起こりません</translation>
    </message>
    <message>
        <source>Two of these states have one number: give each its own first.</source>
        <translation>選んだ状態に同じ番号のものがあります。先にそれぞれ別の番号にしてください。</translation>
    </message>
    <message>
        <source>What application/{0} says is used, and it would call these states {1}/…: take that out first.</source>
        <translation>application/{0} の伝えることが使われていて、これらの状態は {1}/… という名前になります。先にそれを取り除いてください。</translation>
    </message>
    <message>
        <source>What every state has leads {0}, which would be the whole part: lead it to a state, or leave it out of these states first.</source>
        <translation>すべての状態に共通のものの行き先が {0} で、それが部品全体になります。先に別の状態に向けるか、選択から外してください。</translation>
    </message>
    <message>
        <source>What follows {0} depends on more than the end of the part: let {1} lead to one state, without a condition, first.</source>
        <translation>{0} の続きが部品の終わりだけでは決まりません。先に {1} の行き先を、条件なしの一つの状態にしてください。</translation>
    </message>
    <message>
        <source>What people say raises an event by its name: give this event a name</source>
        <translation>人の言葉は名前でイベントを起こします。このイベントに名前を付けてください</translation>
    </message>
    <message>
        <source>What {0} means {1}</source>
        <translation>{0} の意味 {1}</translation>
    </message>
    <message>
        <source>Write it as the text {0}</source>
        <translation>文 {0} として書く</translation>
    </message>
    <message>
        <source>Write {0}</source>
        <translation>{0} と書く</translation>
    </message>
    <message>
        <source>XML or text declaration not at start of entity</source>
        <translation>XML 宣言が先頭にありません</translation>
    </message>
    <message>
        <source>[{0}] has no key {1}; did you mean {2}?</source>
        <translation>[{0}] にキー {1} はありません。{2} のことですか？</translation>
    </message>
    <message>
        <source>a breakpoint&apos;s condition is judged at its moment: it can not have “for”</source>
        <translation>ブレークポイントの条件はその時点で判定されます。「継続」は使えません</translation>
    </message>
    <message>
        <source>a list of texts such as [&quot;a&quot;, &quot;b&quot;]</source>
        <translation>[&quot;a&quot;, &quot;b&quot;] のような文字列の一覧</translation>
    </message>
    <message>
        <source>a million characters are the most</source>
        <translation>百万文字までです</translation>
    </message>
    <message>
        <source>a person&apos;s use of it</source>
        <translation>人の操作</translation>
    </message>
    <message>
        <source>a situated priority description script</source>
        <translation>状況優先度記述スクリプト</translation>
    </message>
    <message>
        <source>a table such as { &quot;a&quot; = &quot;b&quot; }</source>
        <translation>{ &quot;a&quot; = &quot;b&quot; } のような表</translation>
    </message>
    <message>
        <source>a tag is words of a-z, 0-9, _ and - joined by dots</source>
        <translation>タグは a-z、0-9、_、- の語を点でつないだものです</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>引用符で囲んだ文字列</translation>
    </message>
    <message>
        <source>a touch of the screen raises it</source>
        <translation>画面へのタッチで起こります</translation>
    </message>
    <message>
        <source>above {0}</source>
        <translation>が {0} より大きい</translation>
    </message>
    <message>
        <source>add an expected event of this name there, or raise another</source>
        <translation>この名前のイベントをそこに加えるか、別のイベントを起こしてください</translation>
    </message>
    <message>
        <source>after {0}</source>
        <translation>{0} の後</translation>
    </message>
    <message>
        <source>always hold together</source>
        <translation>いつも一緒に成り立つ</translation>
    </message>
    <message>
        <source>always holds</source>
        <translation>いつも成り立つ</translation>
    </message>
    <message>
        <source>always holds too</source>
        <translation>こちらもいつも成り立つ</translation>
    </message>
    <message>
        <source>an application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>an event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>an unnamed event</source>
        <translation>名前のないイベント</translation>
    </message>
    <message>
        <source>and</source>
        <translation>と</translation>
    </message>
    <message>
        <source>application {0} now comes {1}</source>
        <translation>アプリケーション {0} の位置：{1}</translation>
    </message>
    <message>
        <source>application {0}: its file is {1}, was {2}</source>
        <translation>アプリケーション {0}：ファイルは {1}（前は {2}）</translation>
    </message>
    <message>
        <source>application/{0} is used, and some of its states would have several names</source>
        <translation>application/{0} が使われていて、その状態のいくつかが複数の名前を持つことになります</translation>
    </message>
    <message>
        <source>as written</source>
        <translation>書かれたとおり</translation>
    </message>
    <message>
        <source>at least {0}</source>
        <translation>が {0} 以上</translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>が {0} 以下</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>すぐに</translation>
    </message>
    <message>
        <source>back</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>badly</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>because of #{0}</source>
        <translation>#{0} のため</translation>
    </message>
    <message>
        <source>besides, {0}</source>
        <translation>そのうえ、{0}</translation>
    </message>
    <message>
        <source>breakpoint {0}</source>
        <translation>ブレークポイント {0}</translation>
    </message>
    <message>
        <source>comments or layout</source>
        <translation>コメントか配置</translation>
    </message>
    <message>
        <source>error: {0}</source>
        <translation>エラー：{0}</translation>
    </message>
    <message>
        <source>event {0} comes to {1}</source>
        <translation>イベント {0} が {1} に届く</translation>
    </message>
    <message>
        <source>event {0} did not come while {1} was in {2}, since {3}</source>
        <translation>{3} から {1} が {2} にいる間、イベント {0} は来ていません</translation>
    </message>
    <message>
        <source>from outside</source>
        <translation>外から</translation>
    </message>
    <message>
        <source>here and in what every state has</source>
        <translation>ここと、すべての状態に共通のところに</translation>
    </message>
    <message>
        <source>in {0}, {1} is said {2} → {3}</source>
        <translation>{0} で {1} の読み {2} → {3}</translation>
    </message>
    <message>
        <source>is not {0}</source>
        <translation>が {0} 以外</translation>
    </message>
    <message>
        <source>is one of {0}</source>
        <translation>が {0} のどれか</translation>
    </message>
    <message>
        <source>back to the state before</source>
        <translation>前の状態に戻る</translation>
    </message>
    <message>
        <source> of every state</source>
        <translation>（すべての状態）</translation>
    </message>
    <message>
        <source>A message with values sends these, so its text is never sent: take one of them out</source>
        <translation>値のあるメッセージは値を送るので、本文は送られません。どちらかを取り除いてください</translation>
    </message>
    <message>
        <source>A state that runs a part has no {0} of its own: move it into a state beside it, or into the part</source>
        <translation>部品を動かす状態は自分の{0}を持てません。隣の状態か、部品の中に移してください</translation>
    </message>
    <message>
        <source>A {0} action cannot stand in an event: what the robot visibly does belongs to a state; move it to the state to which the event leads</source>
        <translation>動作「{0}」はイベントには置けません。ロボットの目に見える動作は状態に属します。イベントの行き先の状態に移してください</translation>
    </message>
    <message>
        <source>Add a {0} button to every state</source>
        <translation>すべての状態に「{0}」ボタンを加える</translation>
    </message>
    <message>
        <source>An event without a name is taken as soon as its condition holds: let it lead to a state</source>
        <translation>名前のないイベントは条件が成り立つとすぐに起こります。行き先の状態を決めてください</translation>
    </message>
    <message>
        <source>Declare {0}</source>
        <translation>{0} を宣言する</translation>
    </message>
    <message>
        <source>From {0} nobody comes back to the start but by waiting for a timeout: add a button or a phrase that leads back, best a Home button in every state</source>
        <translation>{0} からは時間切れを待つほかに最初へ戻る方法がありません。戻るためのボタンか言葉を加えてください。すべての状態に「ホーム」ボタンを置くのが最善です</translation>
    </message>
    <message>
        <source>Let people say “{0}” in every state</source>
        <translation>すべての状態で「{0}」と言えるようにする</translation>
    </message>
    <message>
        <source>No module {0} is declared: add it to the modules here with its resources, or to the module information</source>
        <translation>モジュール {0} が宣言されていません。ここのモジュールにリソースとともに加えるか、モジュール情報に加えてください</translation>
    </message>
    <message>
        <source>No text in {0} for {1}: it stays as it is written; translate it in the texts (texts/{2}.po)</source>
        <translation>{1} の {0} の文がありません。書かれたままになります。文の表 (texts/{2}.po) で訳してください</translation>
    </message>
    <message>
        <source>Nothing leads out of the state {0}: add an event or a timeout that leads on, or say that it may end here, if that is meant</source>
        <translation>状態 {0} から出る道がありません。先へ進むイベントか時間切れを加えるか、終わりのつもりなら「ここで終わってよい」としてください</translation>
    </message>
    <message>
        <source>Only an event that leads nowhere can say again: take that out, or let the event lead nowhere</source>
        <translation>言い直しは行き先のないイベントでだけ使えます。取り除くか、イベントの行き先をなくしてください</translation>
    </message>
    <message>
        <source>Raise it to {0} in {1}, above {2}</source>
        <translation>{1} での優先度を {0} にして {2} より上にする</translation>
    </message>
    <message>
        <source>Saying again cannot stand among a state&apos;s actions: put it into an event that leads nowhere, or take it out</source>
        <translation>言い直しは状態の動作としては置けません。行き先のないイベントに移すか、取り除いてください</translation>
    </message>
    <message>
        <source>Several applications need a script that says which of them comes first: begin one, and name it in the project</source>
        <translation>アプリケーションがいくつもあるときは、どれが先かを決めるスクリプトが必要です。スクリプトを始めて、プロジェクトに加えてください</translation>
    </message>
    <message>
        <source>Take its priorities out</source>
        <translation>優先度をすべて取り除く</translation>
    </message>
    <message>
        <source>Take its priority out</source>
        <translation>優先度を取り除く</translation>
    </message>
    <message>
        <source>Take out what says it again</source>
        <translation>言い直しを取り除く</translation>
    </message>
    <message>
        <source>Take the empty condition out</source>
        <translation>空の条件を取り除く</translation>
    </message>
    <message>
        <source>The address of a service cannot be {0}: begin with http://, https://, board:module/request, media: or a reference</source>
        <translation>サービスのアドレスは {0} にはできません。http://、https://、board:モジュール/要求、media:、または参照で始めてください</translation>
    </message>
    <message>
        <source>The application has no state: add one</source>
        <translation>アプリケーションに状態がありません。加えてください</translation>
    </message>
    <message>
        <source>The last situation must always hold, so that there is one: take its condition out, or add a situation without one below it</source>
        <translation>必ずどれかの状況になるように、最後の状況はいつも成り立たなければなりません。条件を取り除くか、その下に条件のない状況を加えてください</translation>
    </message>
    <message>
        <source>The module &quot;{0}&quot; can never hold authority: no situation gives it a priority; give it one in a situation</source>
        <translation>モジュール “{0}” は実行権を持つことがありません。どの状況も優先度を与えていません。どれかの状況で与えてください</translation>
    </message>
    <message>
        <source>The script has no situation: add one</source>
        <translation>スクリプトに状況がありません。加えてください</translation>
    </message>
    <message>
        <source>There are no texts in {0} yet (texts/{1}.po), so all stay as they are written: begin them, or take the language out</source>
        <translation>{0} の文 (texts/{1}.po) がまだないので、すべて書かれたままになります。文を始めるか、この言語を外してください</translation>
    </message>
    <message>
        <source>There is no way back to the start from {0}{1}: add an event or a timeout that leads there, or a Home button to every state</source>
        <translation>{0}{1} から最初へ戻る道がありません。戻るイベントか時間切れ、またはすべての状態に「ホーム」ボタンを加えてください</translation>
    </message>
    <message>
        <source>This condition is empty: put a test into it, or take it out</source>
        <translation>条件が空です。調べるものを加えるか、取り除いてください</translation>
    </message>
    <message>
        <source>This holds too while {0} is missing, as when its sensor is off: ask beside it that {1} exists</source>
        <translation>センサーが切れているときなど {0} がない間も成り立ちます。{1} があることも条件にしてください</translation>
    </message>
    <message>
        <source>This keeps the screen of {0}, with {1}, where anyone passes: give it a screen of its own, or an empty one</source>
        <translation>誰もが通る場所で、{1} のある {0} の画面が残ります。自分の画面か空の画面を置いてください</translation>
    </message>
    <message>
        <source>This takes about {0} s to say, but {1} leaves the state after {2}: give it more time, or let it count only when idle, which is from the end of the speech</source>
        <translation>話すのに約 {0} 秒かかりますが、{1} は {2} 後に状態を離れます。時間を延ばすか、「操作のない間だけ」数えて発話の終わりからにしてください</translation>
    </message>
    <message>
        <source>This timeout, which leads to no state,</source>
        <translation>行き先のないこの時間切れ</translation>
    </message>
    <message>
        <source>What a module requires is either data or a module: give it exactly one of the two</source>
        <translation>モジュールが必要とするのはデータかモジュールのどちらか一方です</translation>
    </message>
    <message>
        <source>What the robot itself keeps is never cleared, so clearing {0} has no effect: take it out, or name a tag of your own</source>
        <translation>ロボット自身が保持するものは消えないので、{0} を消しても効果がありません。取り除くか、自分のタグを指定してください</translation>
    </message>
    <message>
        <source>Whether it exists must be &quot;true&quot; or &quot;false&quot;, not {0}</source>
        <translation>「ある」かどうかは {0} ではなく &quot;true&quot; か &quot;false&quot; としてください</translation>
    </message>
    <message>
        <source>Who has not understood cannot hear it again in {0}: add a button or a phrase that says it again, best a Repeat button in every state</source>
        <translation>{0} では聞き取れなかった人がもう一度聞けません。言い直すボタンか言葉を加えてください。すべての状態に「もう一度」ボタンを置くのが最善です</translation>
    </message>
    <message>
        <source>Write it as {0}, without quotes</source>
        <translation>引用符なしで {0} と書く</translation>
    </message>
    <message>
        <source>a line has exactly one verb of {0}; here: {1}</source>
        <translation>1 行に書ける動詞は {0} のうち 1 つだけです。ここでは：{1}</translation>
    </message>
    <message>
        <source>a scenario has no verb for {0}</source>
        <translation>シナリオに {0} を表す動詞はありません</translation>
    </message>
    <message>
        <source>announced in the network</source>
        <translation>ネットワークに知らせる</translation>
    </message>
    <message>
        <source>at {0} s recorded was {1}, decided now is {2}</source>
        <translation>{0} 秒：記録では {1}、今の判断では {2}</translation>
    </message>
    <message>
        <source>below {0}</source>
        <translation>が {0} より小さい</translation>
    </message>
    <message>
        <source>button</source>
        <translation>ボタン</translation>
    </message>
    <message>
        <source>cannot be {0}: write a name without / { } * and blanks at its ends</source>
        <translation>{0} にはできません。/ { } * と前後の空白のない名前にしてください</translation>
    </message>
    <message>
        <source>cannot be {0}: write something without blanks that does not begin with #</source>
        <translation>{0} にはできません。空白がなく # で始まらない名前にしてください</translation>
    </message>
    <message>
        <source>clear {0}</source>
        <translation>{0} を消す</translation>
    </message>
    <message>
        <source>comments or notes changed</source>
        <translation>コメントかメモの変更</translation>
    </message>
    <message>
        <source>correct the name, write it by an action, a component or [tags], or say in the module information who provides it</source>
        <translation>名前を直すか、動作・画面要素・[tags] で書き込むか、提供するものをモジュール情報に書いてください</translation>
    </message>
    <message>
        <source>data {0}</source>
        <translation>データ {0}</translation>
    </message>
    <message>
        <source>declare it here</source>
        <translation>ここで宣言してください</translation>
    </message>
    <message>
        <source>declare it in the module information</source>
        <translation>モジュール情報で宣言してください</translation>
    </message>
    <message>
        <source>declare it in the script, or in the module information</source>
        <translation>スクリプトかモジュール情報で宣言してください</translation>
    </message>
    <message>
        <source>did you mean {0}?</source>
        <translation>{0} のことですか？</translation>
    </message>
    <message>
        <source>duplicate attribute</source>
        <translation>属性の重複</translation>
    </message>
    <message>
        <source>durable tags</source>
        <translation>保存されるタグ</translation>
    </message>
    <message>
        <source>dwell cannot stand together with until or limit: take one of them out</source>
        <translation>dwell は until や limit と一緒には使えません。どちらかを取り除いてください</translation>
    </message>
    <message>
        <source>ed:accept has no effect on &lt;{0}&gt;: put it on the element that holds it, or on one inside it</source>
        <translation>ed:accept は &lt;{0}&gt; では効きません。それを含む要素か、その中の要素に置いてください</translation>
    </message>
    <message>
        <source>ed:accept names {0} here, but there is no such warning about this or anything in it: take that out</source>
        <translation>ed:accept が {0} を指していますが、この要素にも中にもその警告はありません。取り除いてください</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>empty screen</source>
        <translation>空の画面</translation>
    </message>
    <message>
        <source>ends at the latest after</source>
        <translation>遅くとも終わるまで</translation>
    </message>
    <message>
        <source>espeak-ng has no voice for {0}: speeches in it are shown, not heard; give the robot another voice, or leave the language out</source>
        <translation>espeak-ng に {0} の声がありません。この言語の発話は音にならず、画面に表示されます。別の声を用意するか、この言語を外してください</translation>
    </message>
    <message>
        <source>espeak-ng has no voice for {0}: this is shown, not heard; give the robot another voice, or speak another language</source>
        <translation>espeak-ng に {0} の声がありません。音にならず、画面に表示されます。別の声を用意するか、別の言語で話してください</translation>
    </message>
    <message>
        <source>event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>event of a touch</source>
        <translation>タッチのイベント</translation>
    </message>
    <message>
        <source>event when done</source>
        <translation>完了時のイベント</translation>
    </message>
    <message>
        <source>event when failed</source>
        <translation>失敗時のイベント</translation>
    </message>
    <message>
        <source>event {0}</source>
        <translation>イベント {0}</translation>
    </message>
    <message>
        <source>event {0} comes to {1}, raised by {2}</source>
        <translation>イベント {0} が {1} に届く（{2}が起こした）</translation>
    </message>
    <message>
        <source>event {0}{1}</source>
        <translation>イベント {0}{1}</translation>
    </message>
    <message>
        <source>every state</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>exists</source>
        <translation>がある</translation>
    </message>
    <message>
        <source>folder of media</source>
        <translation>メディアのフォルダー</translation>
    </message>
    <message>
        <source>folder of scenarios</source>
        <translation>シナリオのフォルダー</translation>
    </message>
    <message>
        <source>has other content</source>
        <translation>内容が異なります</translation>
    </message>
    <message>
        <source>high</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>hold text, numbers, true, false, lists and tables only</source>
        <translation>文字列、数、true、false、一覧、表だけを置けます</translation>
    </message>
    <message>
        <source>holds too</source>
        <translation>も成り立つ</translation>
    </message>
    <message>
        <source>image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>in the project</source>
        <translation>プロジェクトに</translation>
    </message>
    <message>
        <source>in the situation {0} {1} has no priority</source>
        <translation>状況 {0} では {1} に優先度がない</translation>
    </message>
    <message>
        <source>in the situation {0} {1} may have {2}</source>
        <translation>状況 {0} では {1} に {2} の可能性がある</translation>
    </message>
    <message>
        <source>in {0}</source>
        <translation>{0} の中</translation>
    </message>
    <message>
        <source>in {0}, {1}: {2} → {3}</source>
        <translation>{0}、{1}：{2} → {3}</translation>
    </message>
    <message>
        <source>input</source>
        <translation>入力欄</translation>
    </message>
    <message>
        <source>is empty: write something, or leave it out</source>
        <translation>が空です。何か書くか、取り除いてください</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>がありません</translation>
    </message>
    <message>
        <source>is neither &quot;true&quot; nor &quot;false&quot;: {0}</source>
        <translation>は &quot;true&quot; でも &quot;false&quot; でもありません：{0}</translation>
    </message>
    <message>
        <source>is neither a whole number nor &quot;none&quot;: {0}</source>
        <translation>は整数でも &quot;none&quot; でもありません：{0}</translation>
    </message>
    <message>
        <source>is no name of a value: {0}; write a tag, or a tag and fields, such as patient.room</source>
        <translation>は値の名前ではありません：{0}。タグか、patient.room のようなタグと項目を書いてください</translation>
    </message>
    <message>
        <source>is no number: {0}</source>
        <translation>は数ではありません：{0}</translation>
    </message>
    <message>
        <source>is no tag or pattern: {0}; write a tag, or one with * or ** for words</source>
        <translation>はタグでもパターンでもありません：{0}。タグか、語の代わりに * や ** を使ったものを書いてください</translation>
    </message>
    <message>
        <source>is no tag: {0}; a tag is words of a-z, 0-9, _ and - joined by dots, each beginning with a letter</source>
        <translation>はタグではありません：{0}。タグは英小文字で始まる a-z、0-9、_、- の語を点でつないだものです</translation>
    </message>
    <message>
        <source>is no topic filter: + is one whole level, # the rest of them</source>
        <translation>はトピックフィルターではありません。+ は一つの段、# は残り全部を表します</translation>
    </message>
    <message>
        <source>is no whole number: {0}</source>
        <translation>は整数ではありません：{0}</translation>
    </message>
    <message>
        <source>is too large a number: {0}</source>
        <translation>は数が大きすぎます：{0}</translation>
    </message>
    <message>
        <source>is {0}</source>
        <translation>が {0}</translation>
    </message>
    <message>
        <source>it began at {0} already</source>
        <translation>{0} にすでに始まっています</translation>
    </message>
    <message>
        <source>it comes from outside: from a module, a message, or the blackboard</source>
        <translation>外から来るものです（モジュール、メッセージ、ブラックボードのどれか）</translation>
    </message>
    <message>
        <source>it comes when a suspension ends</source>
        <translation>中断が終わると来ます</translation>
    </message>
    <message>
        <source>it comes when something is heard that is none of the phrases</source>
        <translation>どの言葉でもないものが聞こえると来ます</translation>
    </message>
    <message>
        <source>it comes when the part enters its end state {0}</source>
        <translation>部品が終わりの状態 {0} に入ると来ます</translation>
    </message>
    <message>
        <source>it could not go on, as {0}</source>
        <translation>続けられませんでした：{0}</translation>
    </message>
    <message>
        <source>it did happen later, at {0}</source>
        <translation>後で、{0} に起こりました</translation>
    </message>
    <message>
        <source>it ended {0} at {1}</source>
        <translation>{1} に終わりました（{0}）</translation>
    </message>
    <message>
        <source>it ends after {0} at the latest</source>
        <translation>遅くとも {0} で終わります</translation>
    </message>
    <message>
        <source>it had not begun</source>
        <translation>まだ始まっていませんでした</translation>
    </message>
    <message>
        <source>it has been running since {0}</source>
        <translation>{0} から続いています</translation>
    </message>
    <message>
        <source>it is optional, and {0} did not hold {1}</source>
        <translation>なくてもよい動作で、{0} は {1} を持っていませんでした</translation>
    </message>
    <message>
        <source>it is what is heard as {0}</source>
        <translation>{0} と聞こえると起こります</translation>
    </message>
    <message>
        <source>it stays at least {0}</source>
        <translation>少なくとも {0} は続きます</translation>
    </message>
    <message>
        <source>it stays until {0}</source>
        <translation>次のときまで続きます：{0}</translation>
    </message>
    <message>
        <source>it waits for an action before it, or has been superseded</source>
        <translation>前の動作を待っているか、別の動作に取って代わられました</translation>
    </message>
    <message>
        <source>it waits for {0}, running since {1}</source>
        <translation>{1} から続いている {0} を待っています</translation>
    </message>
    <message>
        <source>it was cancelled at {0}</source>
        <translation>{0} に取り消されました</translation>
    </message>
    <message>
        <source>it would have more than {0} states, because #back can lead back along ways of any length, or parts hold very many states</source>
        <translation>#back がどこまでも戻れるか、部品の状態が非常に多いため、状態が {0} 個を超えます</translation>
    </message>
    <message>
        <source>its end</source>
        <translation>再生の終わり</translation>
    </message>
    <message>
        <source>its file is {0}, was {1}</source>
        <translation>ファイルは {0}（前は {1}）</translation>
    </message>
    <message>
        <source>its timeout of {0} had not run out</source>
        <translation>時間切れの {0} がまだ過ぎていませんでした</translation>
    </message>
    <message>
        <source>its unnamed event could be taken, but a livelock had ended the moment</source>
        <translation>名前のないイベントは起こりえましたが、堂々巡りのためその時点で打ち切られました</translation>
    </message>
    <message>
        <source>its unnamed event could be taken, but by then {0} was leaving</source>
        <translation>名前のないイベントは起こりえましたが、{0} はもう離れるところでした</translation>
    </message>
    <message>
        <source>its unnamed event could be taken, but {0}</source>
        <translation>名前のないイベントは起こりえましたが、{0}</translation>
    </message>
    <message>
        <source>junk after document element</source>
        <translation>文書要素の後に余計なものがある</translation>
    </message>
    <message>
        <source>leads to</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>let the module that writes it provide it</source>
        <translation>書き込むモジュールの「提供するもの」に加えてください</translation>
    </message>
    <message>
        <source>let the timeout lead to a state, or add an expected event of this name</source>
        <translation>時間切れに行き先を付けるか、この名前のイベントを加えてください</translation>
    </message>
    <message>
        <source>list</source>
        <translation>一覧</translation>
    </message>
    <message>
        <source>lists and objects stand too deep in each other; take some out</source>
        <translation>リストとオブジェクトの入れ子が深すぎます。いくつか減らしてください</translation>
    </message>
    <message>
        <source>looks or foreign data changed ({0})</source>
        <translation>見た目か外部データの変更（{0}）</translation>
    </message>
    <message>
        <source>may be interrupted by speech</source>
        <translation>言葉で割り込める</translation>
    </message>
    <message>
        <source>meant as an end</source>
        <translation>終わりのつもり</translation>
    </message>
    <message>
        <source>media {0} {1}</source>
        <translation>メディア {0} {1}</translation>
    </message>
    <message>
        <source>message {0} {1}</source>
        <translation>メッセージ {0} {1}</translation>
    </message>
    <message>
        <source>module information</source>
        <translation>モジュール情報</translation>
    </message>
    <message>
        <source>module {0}</source>
        <translation>モジュール {0}</translation>
    </message>
    <message>
        <source>module {0} ({1})</source>
        <translation>モジュール {0}（{1}）</translation>
    </message>
    <message>
        <source>most characters</source>
        <translation>最大文字数</translation>
    </message>
    <message>
        <source>moved in the drawing</source>
        <translation>図の上で移動</translation>
    </message>
    <message>
        <source>movie</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>must be [x, y, heading]: two numbers in metres and one in degrees</source>
        <translation>は [x, y, 向き] でなければなりません。メートルで二つの数と、度で一つの数です</translation>
    </message>
    <message>
        <source>must be above 0 seconds, not {0}</source>
        <translation>は {0} ではなく 0 秒より長くしてください</translation>
    </message>
    <message>
        <source>must be at least 1, not {0}</source>
        <translation>は {0} ではなく 1 以上にしてください</translation>
    </message>
    <message>
        <source>must be given as &quot;event:NAME&quot; or &quot;tag:NAME&quot;</source>
        <translation>は &quot;event:名前&quot; か &quot;tag:名前&quot; の形にしてください</translation>
    </message>
    <message>
        <source>must be {0} or {1}, not {2}</source>
        <translation>は {2} ではなく {0} か {1} にしてください</translation>
    </message>
    <message>
        <source>must not be below 0: {0}</source>
        <translation>は 0 以上にしてください：{0}</translation>
    </message>
    <message>
        <source>name {0} twice: once is enough</source>
        <translation>{0} が二回あります。一回で十分です</translation>
    </message>
    <message>
        <source>names no broker: give mqtt://HOST or mqtts://HOST, a user and a password</source>
        <translation>はブローカーを指していません。mqtt://ホスト か mqtts://ホスト と、ユーザーとパスワードを指定してください</translation>
    </message>
    <message>
        <source>need of {0}</source>
        <translation>{0} の必要</translation>
    </message>
    <message>
        <source>needs a tag, not {0}</source>
        <translation>には {0} ではなくタグが必要です</translation>
    </message>
    <message>
        <source>no element</source>
        <translation>要素がない</translation>
    </message>
    <message>
        <source>no event or timeout that can be taken leads to it</source>
        <translation>そこへ向かうイベントも時間切れも起こりえません</translation>
    </message>
    <message>
        <source>no further event</source>
        <translation>続く出来事なし</translation>
    </message>
    <message>
        <source>no module {0} is declared</source>
        <translation>モジュール {0} は宣言されていません</translation>
    </message>
    <message>
        <source>no situation</source>
        <translation>状況なし</translation>
    </message>
    <message>
        <source>no state expects it</source>
        <translation>どの状態もそれを待っていません</translation>
    </message>
    <message>
        <source>no value can be so: {0}</source>
        <translation>そのような値はありません：{0}</translation>
    </message>
    <message>
        <source>nobody held {0}</source>
        <translation>{0} は誰も持っていませんでした</translation>
    </message>
    <message>
        <source>none of the states {0} expects it</source>
        <translation>状態 {0} のどれもそれを待っていません</translation>
    </message>
    <message>
        <source>none of these held: {0}</source>
        <translation>次のどれも成り立ちませんでした：{0}</translation>
    </message>
    <message>
        <source>none of: {0}</source>
        <translation>のどれでもありません：{0}</translation>
    </message>
    <message>
        <source>not well-formed</source>
        <translation>整形式でない</translation>
    </message>
    <message>
        <source>not well-formed (invalid token)</source>
        <translation>整形式でない（無効な文字）</translation>
    </message>
    <message>
        <source>notes, or what is not used</source>
        <translation>覚え書き、または使われないもの</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>nothing of that</source>
        <translation>そのようなことはしていない</translation>
    </message>
    <message>
        <source>on this screen</source>
        <translation>この画面に</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>{0} のどれか</translation>
    </message>
    <message>
        <source>only states that cannot be reached themselves lead to it ({0})</source>
        <translation>そこへは、それ自体たどり着けない状態（{0}）からしか行けません</translation>
    </message>
    <message>
        <source>only while nothing happens</source>
        <translation>何も起こらない間だけ</translation>
    </message>
    <message>
        <source>operator {0}</source>
        <translation>操作者 {0}</translation>
    </message>
    <message>
        <source>or</source>
        <translation>または</translation>
    </message>
    <message>
        <source>order of languages {0} → {1}</source>
        <translation>言語の順 {0} → {1}</translation>
    </message>
    <message>
        <source>others with a higher priority always hold what it could ask for</source>
        <translation>求めうるものは、いつも優先度の高いほかのモジュールが持っています</translation>
    </message>
    <message>
        <source>param {0}</source>
        <translation>param {0}</translation>
    </message>
    <message>
        <source>param {0} {1}</source>
        <translation>param {0} {1}</translation>
    </message>
    <message>
        <source>part of always</source>
        <translation>すべての状態に共通の部分</translation>
    </message>
    <message>
        <source>part {0}: its file is {1}, was {2}</source>
        <translation>部品 {0}：ファイルは {1}（前は {2}）</translation>
    </message>
    <message>
        <source>phrase {0}</source>
        <translation>言葉 {0}</translation>
    </message>
    <message>
        <source>priority of {0}</source>
        <translation>{0} の優先度</translation>
    </message>
    <message>
        <source>priority of {0} {1}</source>
        <translation>{0} の優先度 {1}</translation>
    </message>
    <message>
        <source>private tags</source>
        <translation>個人情報のタグ</translation>
    </message>
    <message>
        <source>provided data {0}</source>
        <translation>提供するデータ {0}</translation>
    </message>
    <message>
        <source>result {0}</source>
        <translation>結果 {0}</translation>
    </message>
    <message>
        <source>result {0} from {1}</source>
        <translation>{1} からの結果 {0}</translation>
    </message>
    <message>
        <source>robot {0} on {1}</source>
        <translation>ロボット {0}（{1}）</translation>
    </message>
    <message>
        <source>robot {0} {1}</source>
        <translation>ロボット {0} {1}</translation>
    </message>
    <message>
        <source>runs on when the state is left</source>
        <translation>状態を離れても続く</translation>
    </message>
    <message>
        <source>setting must be a table: [[setting]]</source>
        <translation>設定は表 [[setting]] でなければなりません</translation>
    </message>
    <message>
        <source>setting {0}</source>
        <translation>設定 {0}</translation>
    </message>
    <message>
        <source>setting {0} {1}</source>
        <translation>設定 {0} {1}</translation>
    </message>
    <message>
        <source>setting {0}: choice</source>
        <translation>設定 {0}：選択肢</translation>
    </message>
    <message>
        <source>setting {0}: choices {1} → {2}</source>
        <translation>設定 {0}：選択肢 {1} → {2}</translation>
    </message>
    <message>
        <source>setting {0}: {1} {2} → {3}</source>
        <translation>設定 {0}：{1} {2} → {3}</translation>
    </message>
    <message>
        <source>situation {0}</source>
        <translation>状況 {0}</translation>
    </message>
    <message>
        <source>situation {0} after {1}</source>
        <translation>状況 {1} の次に状況 {0}</translation>
    </message>
    <message>
        <source>situation {0}, which goes before {1}, was current since {2}</source>
        <translation>{1} より先の状況 {0} が {2} から続いていました</translation>
    </message>
    <message>
        <source>so this event is never taken</source>
        <translation>そのためこのイベントは起こりません</translation>
    </message>
    <message>
        <source>so this situation is never current</source>
        <translation>そのためこの状況になることはありません</translation>
    </message>
    <message>
        <source>so this situation never ends by it</source>
        <translation>そのためこの状況がそれで終わることはありません</translation>
    </message>
    <message>
        <source>something else stands there now</source>
        <translation>そこには今は別のものがあります</translation>
    </message>
    <message>
        <source>sound {0}</source>
        <translation>音 {0}</translation>
    </message>
    <message>
        <source>speech {0}</source>
        <translation>発話 {0}</translation>
    </message>
    <message>
        <source>starts in {0} → {1}</source>
        <translation>開始の状態 {0} → {1}</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>state {0}</source>
        <translation>状態 {0}</translation>
    </message>
    <message>
        <source>state {0}: now in {1}, as {2}</source>
        <translation>状態 {0}：今は {1} の {2}</translation>
    </message>
    <message>
        <source>stays at least</source>
        <translation>最低でも続く</translation>
    </message>
    <message>
        <source>tag at the start</source>
        <translation>開始時のタグ</translation>
    </message>
    <message>
        <source>taken from</source>
        <translation>引き継ぎ元</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>text size</source>
        <translation>文字の大きさ</translation>
    </message>
    <message>
        <source>the condition can not be read: {0}</source>
        <translation>条件を読み取れません: {0}</translation>
    </message>
    <message>
        <source>the condition of situation {0} holds</source>
        <translation>状況 {0} の条件が成り立つ</translation>
    </message>
    <message>
        <source>the condition of situation {0} no longer holds</source>
        <translation>状況 {0} の条件が成り立たなくなる</translation>
    </message>
    <message>
        <source>the condition of {0} did not hold: {1}</source>
        <translation>{0} の条件が成り立っていませんでした：{1}</translation>
    </message>
    <message>
        <source>the event resumed leaves state {0} before its screen was shown, and &lt;always&gt; has a screen</source>
        <translation>イベント resumed が画面を表示する前に状態 {0} を離れ、すべての状態に共通の画面がある</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>the guard of its unnamed event did not hold: {0}</source>
        <translation>名前のないイベントの条件が成り立っていませんでした：{0}</translation>
    </message>
    <message>
        <source>the movie of &lt;always&gt; would begin again with the start state</source>
        <translation>すべての状態に共通の動画が開始状態とともに始まり直す</translation>
    </message>
    <message>
        <source>the movie {0} is kept in state {1}, where another screen of &lt;always&gt; lies above it</source>
        <translation>動画 {0} は状態 {1} でも残るが、そこでは共通の別の画面が上に重なる</translation>
    </message>
    <message>
        <source>the next waits for it</source>
        <translation>次はこれを待つ</translation>
    </message>
    <message>
        <source>the page</source>
        <translation>画面の地</translation>
    </message>
    <message>
        <source>the recording&apos;s snapshot is damaged, or another situ&apos;s</source>
        <translation>記録のスナップショットが壊れているか、別の situ のものです</translation>
    </message>
    <message>
        <source>the same start, written out or left to the first state</source>
        <translation>開始は同じで、明示したか、最初の状態に任せたかの違いだけ</translation>
    </message>
    <message>
        <source>the same state</source>
        <translation>同じ状態</translation>
    </message>
    <message>
        <source>the same state anew</source>
        <translation>同じ状態をもう一度</translation>
    </message>
    <message>
        <source>the scenario has ended; delete this line or move the end</source>
        <translation>シナリオは終わっています。この行を消すか、終わりを後ろへ移してください</translation>
    </message>
    <message>
        <source>the situations that give it a priority are never current</source>
        <translation>優先度を与える状況になることがありません</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>the state is the right one, but {0}</source>
        <translation>状態は合っていますが、{0}</translation>
    </message>
    <message>
        <source>the timeout of every state</source>
        <translation>すべての状態に共通の時間切れ</translation>
    </message>
    <message>
        <source>the unnamed event</source>
        <translation>名前のないイベント</translation>
    </message>
    <message>
        <source>the unnamed event ({0})</source>
        <translation>名前のないイベント（{0}）</translation>
    </message>
    <message>
        <source>the voice was taken by {0} since {1}</source>
        <translation>{1} から {0} が声を使っていました</translation>
    </message>
    <message>
        <source>there is no application {0}, only {1}</source>
        <translation>アプリケーション {0} はありません。あるのは {1} です</translation>
    </message>
    <message>
        <source>there is no event {0} in this trace; its last is {1}</source>
        <translation>この記録にイベント {0} はありません。最後は {1} です</translation>
    </message>
    <message>
        <source>there is no situation {0}, only {1}</source>
        <translation>状況 {0} はありません。あるのは {1} です</translation>
    </message>
    <message>
        <source>this must not hold, and did: {0}</source>
        <translation>成り立ってはならないのに成り立っていました：{0}</translation>
    </message>
    <message>
        <source>this project</source>
        <translation>このプロジェクト</translation>
    </message>
    <message>
        <source>this template has no texts in {0}; it has them in: {1}</source>
        <translation>このひな形には {0} の文がありません。あるのは {1} です</translation>
    </message>
    <message>
        <source>time goes back: {0} after {1}; order the lines by time</source>
        <translation>時間が戻っています：{1} の後に {0}。行を時間の順に並べてください</translation>
    </message>
    <message>
        <source>true or false, without quotes</source>
        <translation>引用符なしの true か false</translation>
    </message>
    <message>
        <source>unknown application {0}; there is {1}</source>
        <translation>アプリケーション {0} はありません。あるのは {1} です</translation>
    </message>
    <message>
        <source>until of {0} held, so it does not begin: {1}</source>
        <translation>{0} の「終わる条件」が成り立っていたので始まりません：{1}</translation>
    </message>
    <message>
        <source>version {0} takes over, deployed by {1}</source>
        <translation>{1} が配備したバージョン {0} に切り替わる</translation>
    </message>
    <message>
        <source>version {0} takes over, deployed by {1}; changed: {2}</source>
        <translation>{1} が配備したバージョン {0} に切り替わる（変更：{2}）</translation>
    </message>
    <message>
        <source>warning: {0}</source>
        <translation>警告：{0}</translation>
    </message>
    <message>
        <source>well</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>you</source>
        <translation>あなた</translation>
    </message>
    <message>
        <source>you delete {0}</source>
        <translation>あなたが {0} を消す</translation>
    </message>
    <message>
        <source>you set {0} to {1}</source>
        <translation>あなたが {0} を {1} にする</translation>
    </message>
    <message>
        <source>{0} (part of every state of {1}, and above what a state itself shows)</source>
        <translation>{0}（{1} のすべての状態に共通の部分で、状態自身が表示するものより上にあります）</translation>
    </message>
    <message>
        <source>{0} (part of every state, and above what a state itself shows)</source>
        <translation>{0}（すべての状態に共通の部分で、状態自身が表示するものより上にあります）</translation>
    </message>
    <message>
        <source>{0} and was taken</source>
        <translation>{0}。そのとおり進みました</translation>
    </message>
    <message>
        <source>{0} asked for {1} from {2} to {3} in vain, and not again since</source>
        <translation>{0} は {2} から {3} まで {1} を要求しましたが得られず、その後は要求していません</translation>
    </message>
    <message>
        <source>{0} asks for {1}</source>
        <translation>{0} が {1} を求める</translation>
    </message>
    <message>
        <source>{0} asks for {1} together: all of them or none</source>
        <translation>{0} は {1} をまとめて求めています（全部か、なしか）</translation>
    </message>
    <message>
        <source>{0} begins {1}</source>
        <translation>{0} が {1} を始める</translation>
    </message>
    <message>
        <source>{0} came at {1}</source>
        <translation>{0} が {1} に来ました</translation>
    </message>
    <message>
        <source>{0} connects</source>
        <translation>{0} が接続する</translation>
    </message>
    <message>
        <source>{0} deletes {1}</source>
        <translation>{0} が {1} を消す</translation>
    </message>
    <message>
        <source>{0} did not ask for {1}</source>
        <translation>{0} は {1} を求めていませんでした</translation>
    </message>
    <message>
        <source>{0} did not ask for {1}, only for {2}</source>
        <translation>{0} は {1} を求めておらず、求めていたのは {2} だけです</translation>
    </message>
    <message>
        <source>{0} did not declare {1}, only {2}</source>
        <translation>{0} は {1} を宣言しておらず、宣言しているのは {2} だけです</translation>
    </message>
    <message>
        <source>{0} ends badly: {1}</source>
        <translation>{0} が失敗する：{1}</translation>
    </message>
    <message>
        <source>{0} ends well</source>
        <translation>{0} が終わる</translation>
    </message>
    <message>
        <source>{0} enters {1}</source>
        <translation>{0} が {1} に入る</translation>
    </message>
    <message>
        <source>{0} gave {1} back at {2} and has not asked for it again</source>
        <translation>{0} は {1} を {2} に返し、その後は求めていません</translation>
    </message>
    <message>
        <source>{0} gets {1}</source>
        <translation>{0} が {1} を得る</translation>
    </message>
    <message>
        <source>{0} gets {1} from {2}</source>
        <translation>{0} が {2} から {1} を得る</translation>
    </message>
    <message>
        <source>{0} gives back {1}</source>
        <translation>{0} が {1} を返す</translation>
    </message>
    <message>
        <source>{0} gives {1} no priority in any situation: give it one</source>
        <translation>{0} はどの状況でも {1} に優先度を与えていません。どれかで与えてください</translation>
    </message>
    <message>
        <source>{0} goes from {1} to {2} by {3}</source>
        <translation>{0} が {3} で {1} から {2} へ移る</translation>
    </message>
    <message>
        <source>{0} goes on</source>
        <translation>{0} が再開する</translation>
    </message>
    <message>
        <source>{0} had not started yet</source>
        <translation>{0} はまだ始まっていませんでした</translation>
    </message>
    <message>
        <source>{0} has ended at {1} by until or limit and begins again only after its condition has once been false</source>
        <translation>{0} は終わる条件か期限により {1} に終わり、条件が一度成り立たなくなるまで再び始まりません</translation>
    </message>
    <message>
        <source>{0} has ended by until or limit and begins again only after its condition has once been false</source>
        <translation>{0} は終わる条件か期限により終わり、条件が一度成り立たなくなるまで再び始まりません</translation>
    </message>
    <message>
        <source>{0} has no priority in {1}</source>
        <translation>{0} は {1} では優先度がありません</translation>
    </message>
    <message>
        <source>{0} has no state {1}</source>
        <translation>{0} に状態 {1} はありません</translation>
    </message>
    <message>
        <source>{0} has no such action</source>
        <translation>{0} にそのような動作はありません</translation>
    </message>
    <message>
        <source>{0} held {1} already, since {2}</source>
        <translation>{0} は {2} からすでに {1} を持っていました</translation>
    </message>
    <message>
        <source>{0} held {1} but had no valid command for it</source>
        <translation>{0} は {1} を持っていましたが、有効な命令がありませんでした</translation>
    </message>
    <message>
        <source>{0} held {1} since {2}</source>
        <translation>{0} が {2} から {1} を持っていました</translation>
    </message>
    <message>
        <source>{0} ignores {1}: it does not expect it here</source>
        <translation>{0} は {1} を無視する：ここでは待っていない</translation>
    </message>
    <message>
        <source>{0} ignores {1}: it has no guard for it that holds</source>
        <translation>{0} は {1} を無視する：条件が成り立つものがない</translation>
    </message>
    <message>
        <source>{0} ignores {1}: it is suspended</source>
        <translation>{0} は {1} を無視する：中断している</translation>
    </message>
    <message>
        <source>{0} ignores {1}: it {2}</source>
        <translation>{0} は {1} を無視する：{2}</translation>
    </message>
    <message>
        <source>{0} is cancelled</source>
        <translation>{0} が取り消される</translation>
    </message>
    <message>
        <source>{0} is lost</source>
        <translation>{0} が失われる</translation>
    </message>
    <message>
        <source>{0} is no longer paused, by {1}</source>
        <translation>{1} が {0} の一時停止を解く</translation>
    </message>
    <message>
        <source>{0} is not there any more</source>
        <translation>{0} はもうありません</translation>
    </message>
    <message>
        <source>{0} is paused in {1} by {2}</source>
        <translation>{2} が {0} を {1} で一時停止する</translation>
    </message>
    <message>
        <source>{0} is private, and this copies it to {1}, which is not: make that private too ([privacy] private), or do without the copy</source>
        <translation>{0} は非公開なのに、公開の {1} へ写しています。そちらも非公開にするか ([privacy] private)、写さないでください</translation>
    </message>
    <message>
        <source>{0} is suspended: it does not hold {1}</source>
        <translation>{0} が中断する：{1} を持っていない</translation>
    </message>
    <message>
        <source>{0} is there already</source>
        <translation>{0} はもうあります</translation>
    </message>
    <message>
        <source>{0} is used but not observed: add it to the data observed</source>
        <translation>{0} は使われていますが観測されていません。観測するデータに加えてください</translation>
    </message>
    <message>
        <source>{0} leads back, and there was nothing to go back to</source>
        <translation>{0} は前に戻りますが、戻る先がありませんでした</translation>
    </message>
    <message>
        <source>{0} leads to back</source>
        <translation>{0} は前の状態に戻ります</translation>
    </message>
    <message>
        <source>{0} leads to {1}</source>
        <translation>{0} の行き先は {1} です</translation>
    </message>
    <message>
        <source>{0} leaves {1}</source>
        <translation>{0} が {1} を離れる</translation>
    </message>
    <message>
        <source>{0} lets {1} {2}</source>
        <translation>{0} が {1} に {2} をさせる</translation>
    </message>
    <message>
        <source>{0} lie over it, and a touch there does not reach it</source>
        <translation>{0} が重なっていて、そこに触れても届きません</translation>
    </message>
    <message>
        <source>{0} lie over it, so it cannot be read</source>
        <translation>{0} が重なっていて、読めません</translation>
    </message>
    <message>
        <source>{0} lie over the whole of it, so it is never seen</source>
        <translation>{0} が全体に重なっていて、見えません</translation>
    </message>
    <message>
        <source>{0} lies over it, and a touch there does not reach it</source>
        <translation>{0} が重なっていて、そこに触れても届きません</translation>
    </message>
    <message>
        <source>{0} lies over it, so it cannot be read</source>
        <translation>{0} が重なっていて、読めません</translation>
    </message>
    <message>
        <source>{0} lies over the whole of it, so it is never seen</source>
        <translation>{0} が全体に重なっていて、見えません</translation>
    </message>
    <message>
        <source>{0} loses {1}, nobody holds it</source>
        <translation>{0} が {1} を失い、誰も持っていない</translation>
    </message>
    <message>
        <source>{0} more actions fit; name its state to be told of one</source>
        <translation>ほかに {0} 個の動作が当てはまります。一つに絞るには状態を指定してください</translation>
    </message>
    <message>
        <source>{0} moves {1}: {2}</source>
        <translation>{0} が {1} を動かす：{2}</translation>
    </message>
    <message>
        <source>{0} of always</source>
        <translation>{0}（すべての状態）</translation>
    </message>
    <message>
        <source>{0} of an event of {1}</source>
        <translation>{1} のイベントの {0}</translation>
    </message>
    <message>
        <source>{0} of its screen raises it by {1}</source>
        <translation>画面の {0} が{1}で起こします</translation>
    </message>
    <message>
        <source>{0} of state {1}</source>
        <translation>状態 {1} の {0}</translation>
    </message>
    <message>
        <source>{0} of {1} raises it</source>
        <translation>{1} の {0} が起こします</translation>
    </message>
    <message>
        <source>{0} plays {1}</source>
        <translation>{0} が {1} を鳴らす</translation>
    </message>
    <message>
        <source>{0} raises it when it ends {1}: {2}</source>
        <translation>{0} が終わると（{1}）起こります：{2}</translation>
    </message>
    <message>
        <source>{0} says {1}</source>
        <translation>{0} が {1} と言う</translation>
    </message>
    <message>
        <source>{0} sets {1} to {2}</source>
        <translation>{0} が {1} を {2} にする</translation>
    </message>
    <message>
        <source>{0} shows another screen</source>
        <translation>{0} が別の画面を出す</translation>
    </message>
    <message>
        <source>{0} shows something else on the {1}</source>
        <translation>{0} が {1} に別のものを出す</translation>
    </message>
    <message>
        <source>{0} shows the screen of {1}</source>
        <translation>{0} が {1} の画面を出す</translation>
    </message>
    <message>
        <source>{0} shows {1} on the {2}</source>
        <translation>{0} が {2} に {1} を出す</translation>
    </message>
    <message>
        <source>{0} stays</source>
        <translation>{0} は状態を変えません</translation>
    </message>
    <message>
        <source>{0} stops and holds</source>
        <translation>{0} が止まり、そのまま保つ</translation>
    </message>
    <message>
        <source>{0} uses {1} here but does not declare it: add it to the resources of its module</source>
        <translation>{0} はここで {1} を使いますが、宣言していません。そのモジュールのリソースに加えてください</translation>
    </message>
    <message>
        <source>{0} was already moved by {1}: {2}</source>
        <translation>{0} はすでに {1} が動かしていました：{2}</translation>
    </message>
    <message>
        <source>{0} was current already, since {1}</source>
        <translation>{1} からすでに {0} でした</translation>
    </message>
    <message>
        <source>{0} was in {1} already, since {2}</source>
        <translation>{0} は {2} からすでに {1} にいました</translation>
    </message>
    <message>
        <source>{0} was in {1} since {2}</source>
        <translation>{0} は {2} から {1} にいました</translation>
    </message>
    <message>
        <source>{0} was lost at {1} and has not asked again</source>
        <translation>{0} は {1} に失われ、その後は求めていません</translation>
    </message>
    <message>
        <source>{0} was not suspended</source>
        <translation>{0} は中断していませんでした</translation>
    </message>
    <message>
        <source>{0} was suspended since {1}: it did not hold {2}</source>
        <translation>{0} は {1} から中断していました：{2} を持っていませんでした</translation>
    </message>
    <message>
        <source>{0} without waiting ({1}): let a condition fail once it was followed, or wait for a timeout or for an event from outside</source>
        <translation>待つことなく {0}（{1}）。一度たどったら条件が成り立たなくなるようにするか、時間切れか外からのイベントを待ってください</translation>
    </message>
    <message>
        <source>{0}, and an event before this one took it: {1}</source>
        <translation>{0}。先にあるイベントが取りました：{1}</translation>
    </message>
    <message>
        <source>{0}, and no way leads from there to {1}</source>
        <translation>{0}。そこから {1} へ行く道はありません</translation>
    </message>
    <message>
        <source>{0}, but its guard did not hold: {1}</source>
        <translation>{0}。しかし条件が成り立っていませんでした：{1}</translation>
    </message>
    <message>
        <source>{0}, but {1}</source>
        <translation>{0}。しかし{1}</translation>
    </message>
    <message>
        <source>{0}, deleted at {1} by {2}</source>
        <translation>{0}（{1} に {2} が消した）</translation>
    </message>
    <message>
        <source>{0}, set at {1} by {2}</source>
        <translation>{0}（{1} に {2} が設定）</translation>
    </message>
    <message>
        <source>{0}: in the start state there is nowhere to go back to: name a state</source>
        <translation>{0}：開始状態には戻り先がありません。状態を指定してください</translation>
    </message>
    <message>
        <source>{0}: is not empty; name a new or an empty folder</source>
        <translation>{0}: 空ではありません。新しいフォルダーか空のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>{0}: it holds a trace without inputs, so it can not be decided again; record with situ run --record</source>
        <translation>{0}：入力のないトレースなので、もう一度判断させることはできません。situ run --record で記録してください</translation>
    </message>
    <message>
        <source>{0}: it lacks where the robot began</source>
        <translation>{0}：ロボットがどこから始めたかが欠けています</translation>
    </message>
    <message>
        <source>{0}: it was never set</source>
        <translation>{0}：一度も設定されていません</translation>
    </message>
    <message>
        <source>{0}: it was {1}</source>
        <translation>{0}：値は {1} でした</translation>
    </message>
    <message>
        <source>{0}: its snapshot is damaged, or another situ&apos;s</source>
        <translation>{0}：スナップショットが壊れているか、別の situ のものです</translation>
    </message>
    <message>
        <source>{0}: not a recording of situ; give what situ run --record wrote</source>
        <translation>{0}：situ の記録ではありません。situ run --record が書いたものを指定してください</translation>
    </message>
    <message>
        <source>{0}: not told by a trace alone</source>
        <translation>{0}：トレースだけでは分かりません</translation>
    </message>
    <message>
        <source>{0}: priority {1} against {2} of {3} in {4}</source>
        <translation>{0}：{4} での優先度は {1}、{3} は {2}</translation>
    </message>
    <message>
        <source>{0}: priority {1} like {2}, and it came first</source>
        <translation>{0}：優先度は {2} と同じ {1} で、先に求めていました</translation>
    </message>
    <message>
        <source>{0}: private values are masked, so it holds no inputs and can not be decided again; give the recording as it lies on the robot</source>
        <translation>{0}：私的な値が伏せられているため入力がなく、もう一度判断させることはできません。ロボットにあるままの記録を指定してください</translation>
    </message>
    <message>
        <source>{0}: the project that it holds can not be read</source>
        <translation>{0}：中のプロジェクトを読めません</translation>
    </message>
    <message>
        <source>{0}: the state is left first, as {1} without a name {2} then: give it a condition</source>
        <translation>{0}：名前のない {1} がそのとき {2} ので、状態を先に離れます。条件を付けてください</translation>
    </message>
    <message>
        <source>{0}: there is a file of this name; name another folder</source>
        <translation>{0}: その名前のファイルがあります。別のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>{0}: whenever it could be, {1} comes first: change a condition, or their order</source>
        <translation>{0}：起こりうるときには必ず {1} が先になります。条件か順序を変えてください</translation>
    </message>
    <message>
        <source>{0}: {1} comes first, on no condition: put this one before it, or give it one</source>
        <translation>{0}：{1} が先にあり、条件がありません。これをその前に置くか、あちらに条件を付けてください</translation>
    </message>
    <message>
        <source>{0}: {1} had passed</source>
        <translation>{0}：{1} 過ぎていました</translation>
    </message>
    <message>
        <source>{0}:{1}: not an event of a trace: {2}; give what situ simulate or situ trace wrote</source>
        <translation>{0}:{1}：トレースの出来事ではありません：{2}。situ simulate か situ trace が書いたものを指定してください</translation>
    </message>
    <message>
        <source>{0}:{1}: seq {2} after {3}: give the trace of one run</source>
        <translation>{0}:{1}：番号 {3} の後に {2}。1 回の実行のトレースを指定してください</translation>
    </message>
    <message>
        <source>{0}; it counts anew from the end of speech and from every touch</source>
        <translation>{0}。発話の終わりとタッチのたびに数え直します</translation>
    </message>
    <message>
        <source>{0}; it stands still, since {1}</source>
        <translation>{0}。止まっています：{1}</translation>
    </message>
    <message>
        <source>{0}; the nearest way to {1}: {2}</source>
        <translation>{0}。{1} への最も近い道：{2}</translation>
    </message>
    <message>
        <source>{0}; what it commanded, {1}, was older than its authority</source>
        <translation>{0}。出していた命令 {1} は実行権より前のものでした</translation>
    </message>
    <message>
        <source>{0}; {1} was {2}</source>
        <translation>{0}。{1} は {2} でした</translation>
    </message>
    <message>
        <source>“Is one of” needs a list such as [&quot;a&quot;, &quot;b&quot;], not {0}</source>
        <translation>「のどれか」には {0} ではなく [&quot;a&quot;, &quot;b&quot;] のような一覧が必要です</translation>
    </message>
    <message>
        <source>“application” goes with “event” only</source>
        <translation>“application” は “event” とだけ使えます</translation>
    </message>
    <message>
        <source>“at” is a time in seconds, 0 or more</source>
        <translation>“at” は 0 以上の秒数です</translation>
    </message>
    <message>
        <source>“end” is true or left out</source>
        <translation>“end” は true か、省略です</translation>
    </message>
    <message>
        <source>“for” is seconds above 0</source>
        <translation>“for” は 0 より大きい秒数です</translation>
    </message>
    <message>
        <source>“touch” is true or left out</source>
        <translation>“touch” は true か、省略です</translation>
    </message>
    <message>
        <source>the state {0}</source>
        <translation>状態 {0}</translation>
    </message>
    <message>
        <source>the state {0} does not expect it</source>
        <translation>状態 {0} はそれを待っていません</translation>
    </message>
    <message>
        <source>the states {0}</source>
        <translation>状態 {0}</translation>
    </message>
    <message>
        <source>the timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>there is no such position any more</source>
        <translation>その位置はもうありません</translation>
    </message>
    <message>
        <source>these exclude each other: {0}</source>
        <translation>これらは両立しません：{0}</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>timeout leads to</source>
        <translation>時間切れの行き先</translation>
    </message>
    <message>
        <source>timeout {0}{1}</source>
        <translation>時間切れ {0}{1}</translation>
    </message>
    <message>
        <source>to the state anew</source>
        <translation>状態をもう一度</translation>
    </message>
    <message>
        <source>two components of state {0} are {1}</source>
        <translation>状態 {0} の画面要素二つが {1} です</translation>
    </message>
    <message>
        <source>unclosed CDATA section</source>
        <translation>CDATA が閉じていない</translation>
    </message>
    <message>
        <source>unclosed token</source>
        <translation>タグが閉じていない</translation>
    </message>
    <message>
        <source>undefined entity</source>
        <translation>定義のない実体</translation>
    </message>
    <message>
        <source>unnamed event</source>
        <translation>名前のないイベント</translation>
    </message>
    <message>
        <source>what its screens show and its states expect</source>
        <translation>画面に出るものと、状態が待つもの</translation>
    </message>
    <message>
        <source>whether &quot;{0}&quot; ever holds authority</source>
        <translation>“{0}” が実行権を持つことがあるか</translation>
    </message>
    <message>
        <source>whether its states can go round for ever without waiting</source>
        <translation>待つことなく状態を回り続けることがあるか</translation>
    </message>
    <message>
        <source>whether this can ever hold</source>
        <translation>これが成り立つことがあるか</translation>
    </message>
    <message>
        <source>whether this can go round for ever without waiting</source>
        <translation>待つことなく回り続けることがあるか</translation>
    </message>
    <message>
        <source>whether this event is ever taken</source>
        <translation>このイベントが起こることがあるか</translation>
    </message>
    <message>
        <source>whether this situation is ever current</source>
        <translation>この状況になることがあるか</translation>
    </message>
    <message>
        <source>wide</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>{0} added</source>
        <translation>{0} を追加</translation>
    </message>
    <message>
        <source>{0} another {1}</source>
        <translation>{0} が別の{1}に</translation>
    </message>
    <message>
        <source>{0} can not be a tag: {1}</source>
        <translation>{0} はタグにできません：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be run as a part: it must be an application that can be read</source>
        <translation>{0} は部品として動かせません。読めるアプリケーションでなければなりません</translation>
    </message>
    <message>
        <source>{0} extends itself by way of {1}: take one of the extends out</source>
        <translation>{0} は {1} を通じて自分自身を引き継いでいます。extends のどれかを取り除いてください</translation>
    </message>
    <message>
        <source>{0} from {1}</source>
        <translation>{1} からの {0}</translation>
    </message>
    <message>
        <source>{0} gone</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>{0} has something in every state, which the states around would get too: put it into its states first.</source>
        <translation>{0} にはすべての状態に共通のものがあり、周りの状態にも加わってしまいます。先にそれぞれの状態に移してください。</translation>
    </message>
    <message>
        <source>{0} has the name {1} too: give one of them another</source>
        <translation>{0} も {1} という名前です。一方に別の名前を付けてください</translation>
    </message>
    <message>
        <source>{0} has the resources {1} here and {2} in {3}: make them the same</source>
        <translation>{0} のリソースがここでは {1}、{3} では {2} です。同じにしてください</translation>
    </message>
    <message>
        <source>{0} has the {1} {2} here and {3} in {4}: make them the same</source>
        <translation>{0} の {1} がここでは {2}、{4} では {3} です。同じにしてください</translation>
    </message>
    <message>
        <source>{0} has two priorities in this situation: take one out</source>
        <translation>この状況に {0} の優先度が二つあります。一つを取り除いてください</translation>
    </message>
    <message>
        <source>{0} is a module of this template: give the project another name</source>
        <translation>{0} はこのひな形のモジュールです。プロジェクトに別の名前を付けてください</translation>
    </message>
    <message>
        <source>{0} is an end of {1}, for which {2} waits: leave it out of the selection.</source>
        <translation>{0} は {1} の終わりで、{2} がそれを待っています。選択から外してください。</translation>
    </message>
    <message>
        <source>{0} is another now</source>
        <translation>{0} が別のものに</translation>
    </message>
    <message>
        <source>{0} is covered: {1}; move them apart, or take one away</source>
        <translation>{0} が隠れています：{1}。離すか、一方を取り除いてください</translation>
    </message>
    <message>
        <source>{0} is declared twice: take one out</source>
        <translation>{0} が二回宣言されています。一つを取り除いてください</translation>
    </message>
    <message>
        <source>{0} is no language: write a code such as ja or pt-BR</source>
        <translation>{0} は言語ではありません。ja や pt-BR のような符号を書いてください</translation>
    </message>
    <message>
        <source>{0} is no name for a project: use small letters, digits, - and _, a letter first</source>
        <translation>{0} はプロジェクトの名前にできません。英小文字で始め、小文字、数字、-、_ を使ってください</translation>
    </message>
    <message>
        <source>{0} is no tag or pattern: use words, dots, * and **</source>
        <translation>{0} はタグでもパターンでもありません。語、点、*、** を使ってください</translation>
    </message>
    <message>
        <source>{0} is not known here; did you mean [{1}]?</source>
        <translation>{0} は使えません。[{1}] のことですか？</translation>
    </message>
    <message>
        <source>{0} is not {1}: name another file here</source>
        <translation>{0} は{1}ではありません。別のファイルを指定してください</translation>
    </message>
    <message>
        <source>{0} is observed twice: take one out</source>
        <translation>{0} が二回観測されています。一つを取り除いてください</translation>
    </message>
    <message>
        <source>{0} is private, and this says it before anybody has shown that they are there: say it after they have touched or said something</source>
        <translation>{0} は個人情報ですが、本人がいると分かる前に声に出しています。触れるか話すかした後に言うようにしてください</translation>
    </message>
    <message>
        <source>{0} is private, and this shows it where anyone passes: show it after somebody has touched or said something</source>
        <translation>{0} は個人情報ですが、誰もが通る場所で表示しています。触れるか話すかした後に表示してください</translation>
    </message>
    <message>
        <source>{0} is the number of a state inside the part: give this one another no</source>
        <translation>{0} は部品の中の状態の番号です。これに別の番号を付けてください</translation>
    </message>
    <message>
        <source>{0} is written by the robot itself only: choose another tag</source>
        <translation>{0} はロボット自身だけが書き込みます。別のタグを選んでください</translation>
    </message>
    <message>
        <source>{0} leads back to the state before, which would be outside the part: lead it to a state first.</source>
        <translation>{0} は前の状態に戻りますが、それは部品の外になります。先に行き先の状態を決めてください。</translation>
    </message>
    <message>
        <source>{0} leads back to the state before, which would be the beginning of the part: lead it to a state first, or select it too.</source>
        <translation>{0} は前の状態に戻りますが、それは部品の始まりになります。先に行き先の状態を決めるか、それも選んでください。</translation>
    </message>
    <message>
        <source>{0} leads out of the project: its files lie inside its folder</source>
        <translation>{0} がプロジェクトの外を指しています。ファイルはプロジェクトのフォルダーに置きます</translation>
    </message>
    <message>
        <source>{0} leads out of the project: its media lie inside its folder</source>
        <translation>{0} がプロジェクトの外を指しています。メディアはプロジェクトのフォルダーに置きます</translation>
    </message>
    <message>
        <source>{0} leaves out what every state has, and others do not: select them apart, or make them alike.</source>
        <translation>{0} は共通のものを省いていますが、ほかは省いていません。別々に選ぶか、同じにしてください。</translation>
    </message>
    <message>
        <source>{0} lies outside the screen, which is 100 wide and 100 high: move it in, or make it smaller</source>
        <translation>{0} が幅 100、高さ 100 の画面の外にあります。中に移すか、小さくしてください</translation>
    </message>
    <message>
        <source>{0} more</source>
        <translation>ほか {0} 件</translation>
    </message>
    <message>
        <source>{0} must be a table: [{1}]</source>
        <translation>{0} は表 [{1}] でなければなりません</translation>
    </message>
    <message>
        <source>{0} must be {1}</source>
        <translation>{0} は {1} でなければなりません</translation>
    </message>
    <message>
        <source>{0} must {1}</source>
        <translation>{0} は {1} なければなりません</translation>
    </message>
    <message>
        <source>{0} now comes {1}</source>
        <translation>{0} の位置：{1}</translation>
    </message>
    <message>
        <source>{0} now {1}{2}</source>
        <translation>{0} は今 {1}{2}</translation>
    </message>
    <message>
        <source>{0} of its screen raises it if it can not play</source>
        <translation>画面の {0} が、再生できないときに起こします</translation>
    </message>
    <message>
        <source>{0} of the part begins and ends it: there is nothing in it.</source>
        <translation>部品の {0} が始まりで終わりなので、中に何もありません。</translation>
    </message>
    <message>
        <source>{0} of the part says or does something and then ends it: let an empty state after it be the end first.</source>
        <translation>部品の {0} は何かをしてから部品を終えます。先に、その後の空の状態を終わりにしてください。</translation>
    </message>
    <message>
        <source>{0} raises {1}, but {2}: {3}</source>
        <translation>{0} は {1} を起こしますが、{2}：{3}</translation>
    </message>
    <message>
        <source>{0} requires the module {1}, which nobody declares: {2}</source>
        <translation>{0} はモジュール {1} を必要としますが、どこにも宣言されていません：{2}</translation>
    </message>
    <message>
        <source>{0} requires {1}, which nobody writes: {2}</source>
        <translation>{0} は {1} を必要としますが、書き込むものがありません：{2}</translation>
    </message>
    <message>
        <source>{0} stands here twice: name each application once</source>
        <translation>{0} が二回あります。アプリケーションの名前は一度だけ挙げてください</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} を {1} に</translation>
    </message>
    <message>
        <source>{0} would be an end for which {1} waits: lead it to a state first.</source>
        <translation>{0} は {1} が待つ終わりになります。先に行き先の状態を決めてください。</translation>
    </message>
    <message>
        <source>{0} {1} added: {2}</source>
        <translation>{0} {1} を追加：{2}</translation>
    </message>
    <message>
        <source>{0} {1} gone, was {2}</source>
        <translation>{0} {1} を削除（前は {2}）</translation>
    </message>
    <message>
        <source>{0} {1}{2} gone</source>
        <translation>{0} {1}{2} を削除</translation>
    </message>
    <message>
        <source>{0}, for {1}</source>
        <translation>{0}、{1} の間</translation>
    </message>
    <message>
        <source>{0}, within {1}</source>
        <translation>{0}、{1} 以内</translation>
    </message>
    <message>
        <source>{0}: can not be made: {1}</source>
        <translation>{0}：作れません：{1}</translation>
    </message>
    <message>
        <source>{0}: cannot be exported flat: {1}; leave --flat out</source>
        <translation>{0}：平らにして書き出せません：{1}。--flat を外してください</translation>
    </message>
    <message>
        <source>{0}: cannot be read: {1}</source>
        <translation>{0}：読めません：{1}</translation>
    </message>
    <message>
        <source>{0}: cannot be written: {1}</source>
        <translation>{0}：書き込めません：{1}</translation>
    </message>
    <message>
        <source>{0}: changed while it was being mended, so it was left as it is; run the check again</source>
        <translation>{0}：直している間に変更されたので、そのままにしました。もう一度検査してください</translation>
    </message>
    <message>
        <source>{0}: is no plain file (a pipe, a device): take it out of there</source>
        <translation>{0}：普通のファイルではありません（パイプやデバイス）。取り除いてください</translation>
    </message>
    <message>
        <source>{0}: is read-only: allow it to be written, or write a copy</source>
        <translation>{0}：読み取り専用です。書き込みを許すか、コピーに書いてください</translation>
    </message>
    <message>
        <source>{0}: is there already and not empty; name a new folder</source>
        <translation>{0}：すでにあり、空ではありません。新しいフォルダーを指定してください</translation>
    </message>
    <message>
        <source>{0}: its name is not UTF-8: give it another one</source>
        <translation>{0}：名前が UTF-8 ではありません。別の名前にしてください</translation>
    </message>
    <message>
        <source>{0}: leads out of the project</source>
        <translation>{0}：プロジェクトの外を指しています</translation>
    </message>
    <message>
        <source>{0}: neither a project&apos;s folder, its situ.toml, nor a document (.rbd.xml, .spds.xml, modules.xml)</source>
        <translation>{0}：プロジェクトのフォルダーでも、その situ.toml でも、文書（.rbd.xml、.spds.xml、modules.xml）でもありません</translation>
    </message>
    <message>
        <source>{0}: no such file or folder</source>
        <translation>{0}：ファイルもフォルダーもありません</translation>
    </message>
    <message>
        <source>{0}: no {1} here; give the folder of a project, or a document</source>
        <translation>{0}：ここに {1} がありません。プロジェクトのフォルダーか文書を指定してください</translation>
    </message>
    <message>
        <source>{0}: not a project that can be read</source>
        <translation>{0}：読めるプロジェクトではありません</translation>
    </message>
    <message>
        <source>{0}: phrase of {1}</source>
        <translation>{0}：{1} の言葉</translation>
    </message>
    <message>
        <source>{0}: speech</source>
        <translation>{0}：発話</translation>
    </message>
    <message>
        <source>{0}; did you mean &lt;{1}&gt;?</source>
        <translation>{0}。&lt;{1}&gt; のことですか？</translation>
    </message>
</context>
<context>
    <name>self._canvas</name>
    <message>
        <source>Priority of {0} in {1}</source>
        <translation>{1} での {0} の優先度</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>A priority is a whole number or none, not {0}</source>
        <translation>優先度は整数か none です。{0} は使えません</translation>
    </message>
    <message>
        <source>{0} is too large for a priority</source>
        <translation>{0} は優先度には大きすぎます</translation>
    </message>
</context>
<context>
    <name>sheet</name>
    <message>
        <source>Resize {0}</source>
        <translation>{0} の大きさを変更</translation>
    </message>
    <message>
        <source>Move {0}</source>
        <translation>{0}を移動</translation>
    </message>
    <message>
        <source>Delete {0}</source>
        <translation>{0} を削除</translation>
    </message>
    <message>
        <source>Change text of {0}</source>
        <translation>{0} の文字を変更</translation>
    </message>
</context>
</TS>
