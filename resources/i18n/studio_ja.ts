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
        <source>until {0}</source>
        <translation>終了：{0}</translation>
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
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Set by</source>
        <translation>書き込み元</translation>
    </message>
    <message>
        <source>Ago</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>ブラックボード</translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation>{0} 秒</translation>
    </message>
    <message>
        <source>{0} min</source>
        <translation>{0} 分</translation>
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
        <source>Always</source>
        <translation>すべての状態</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
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
        <source>module</source>
        <translation>モジュール</translation>
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
        <source>{0} of {1}</source>
        <translation>{1} の{0}</translation>
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
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>The layout is being made</source>
        <translation>配置を計算しています</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
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
        <source>only in the list of modules</source>
        <translation>モジュールの一覧でだけ使えます</translation>
    </message>
    <message>
        <source>only in a script</source>
        <translation>スクリプトでだけ使えます</translation>
    </message>
    <message>
        <source>you are in no part</source>
        <translation>部品の中にいません</translation>
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
        <source>open a document first</source>
        <translation>先に文書を開いてください</translation>
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
        <source>there is no problem</source>
        <translation>問題がありません</translation>
    </message>
    <message>
        <source>open a project first</source>
        <translation>先にプロジェクトを開いてください</translation>
    </message>
    <message>
        <source>only in the graph of an application</source>
        <translation>アプリケーションのグラフでだけ使えます</translation>
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
        <source>Graph</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
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
        <source>{0} — {1}</source>
        <translation>{0} — {1}</translation>
    </message>
    <message>
        <source>The drawing is too large to be put on paper in the window: use situ studio PROJECT --picture OUT</source>
        <translation>図が大きすぎて、ウィンドウからは紙に出せません。situ studio PROJECT --picture OUT を使ってください</translation>
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
        <source>Reading {0}</source>
        <translation>{0} を読み込み中</translation>
    </message>
    <message>
        <source>Where shall the copy of the project be?</source>
        <translation>プロジェクトのコピーを置く場所</translation>
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
        <source>States, texts, events, tags</source>
        <translation>状態、文章、イベント、タグ</translation>
    </message>
    <message>
        <source>Find in the project</source>
        <translation>プロジェクト内を検索</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>見つかったもの</translation>
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
    <name>Follower</name>
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
        <source>This can not be left empty.</source>
        <translation>空にはできません。</translation>
    </message>
    <message>
        <source>Change timeout of {0}</source>
        <translation>{0} の時間切れを変更</translation>
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
        <source>This project has no document that can be shown. The problems below say why.</source>
        <translation>表示できる文書がありません。理由は下の問題をご覧ください。</translation>
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
    <name>GroupBox</name>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Remove this group</source>
        <translation>このグループを削除</translation>
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
        <source>Situ Studio</source>
        <translation>Situ Studio</translation>
    </message>
    <message>
        <source>{0} has errors: it can be read, not changed.</source>
        <translation>{0} には誤りがあります。見ることはできますが、変更はできません。</translation>
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
        <source>This has changed meanwhile: there is nothing to mend there now.</source>
        <translation>その間に変わったので、もう直すところはありません。</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>何も選ばれていません。</translation>
    </message>
    <message>
        <source>{0}{1} — Situ Studio</source>
        <translation>{0}{1} — Situ Studio</translation>
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
    <name>PrioritiesEditor</name>
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
        <source>The higher wins; empty: taken away here.</source>
        <translation>大きいほうが優先。空にすると、ここでは取り上げます。</translation>
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
        <source>Show {0} more like these</source>
        <translation>同様のものをあと {0} 件表示</translation>
    </message>
    <message>
        <source>Show only {0} of these {1}</source>
        <translation>{1} 件のうち {0} 件だけ表示</translation>
    </message>
</context>
<context>
    <name>ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>media</source>
        <translation>メディア</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>シナリオ</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
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
    <name>RobotSide</name>
    <message>
        <source>Blackboard</source>
        <translation>ブラックボード</translation>
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
        <source>Connect to a robot</source>
        <translation>ロボットに接続</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
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
        <source>Add {0}</source>
        <translation>{0}を追加</translation>
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
    <name>Session</name>
    <message>
        <source>Take {0} from disk</source>
        <translation>ディスク上の {0} を使う</translation>
    </message>
    <message>
        <source>Join {0} with disk</source>
        <translation>{0} をディスクと統合</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Align {0}</source>
        <translation>{0} を揃える</translation>
    </message>
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
</context>
<context>
    <name>Shortcuts</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
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
    <name>Status</name>
    <message>
        <source>no robot</source>
        <translation>ロボットなし</translation>
    </message>
    <message>
        <source>error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>“In every state” selected</source>
        <translation>「すべての状態」を選択中</translation>
    </message>
    <message>
        <source>thing</source>
        <translation>件</translation>
    </message>
    <message>
        <source>priorities</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>{0} selected</source>
        <translation>{0} 個を選択中</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>states</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>遷移</translation>
    </message>
    <message>
        <source>transitions</source>
        <translation>遷移</translation>
    </message>
    <message>
        <source>situation</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>events</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>timeouts</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>situations</source>
        <translation>状況</translation>
    </message>
    <message>
        <source>module</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>modules</source>
        <translation>モジュール</translation>
    </message>
    <message>
        <source>priority</source>
        <translation>優先度</translation>
    </message>
    <message>
        <source>data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>resource</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>resources</source>
        <translation>リソース</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>things</source>
        <translation>件</translation>
    </message>
    <message>
        <source>{0} not saved</source>
        <translation>{0} が未保存</translation>
    </message>
    <message>
        <source>document</source>
        <translation>文書</translation>
    </message>
    <message>
        <source>documents</source>
        <translation>文書</translation>
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
        <source>within</source>
        <translation>以内</translation>
    </message>
    <message>
        <source>The tag was set less than so many seconds ago.</source>
        <translation>タグに書き込まれてから、この秒数より経っていない。</translation>
    </message>
    <message>
        <source>for</source>
        <translation>継続</translation>
    </message>
    <message>
        <source>It has held without a break for so many seconds.</source>
        <translation>この秒数の間、途切れずに成り立っている。</translation>
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
        <source>After so many seconds without an event the state is left.</source>
        <translation>この秒数イベントがなければ、状態を離れます。</translation>
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
        <source>Counted anew after each touch and speech; still while the robot speaks.</source>
        <translation>触れるか話すたびに数え直します。ロボットが話している間は止まります。</translation>
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
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Welcome</source>
        <translation>ようこそ</translation>
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
        <source>By its address</source>
        <translation>アドレスを指定</translation>
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
        <source>Screens, a way home, a timeout</source>
        <translation>画面、最初への戻り道、時間切れ</translation>
    </message>
    <message>
        <source>Modules that share a robot</source>
        <translation>ロボットを分け合うモジュール</translation>
    </message>
    <message>
        <source>Situations, priorities, a stop</source>
        <translation>状況、優先度、停止</translation>
    </message>
    <message>
        <source>Open a copy of the example {0}</source>
        <translation>例 {0} のコピーを開く</translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation>{0} に戻る</translation>
    </message>
    <message>
        <source>It is still open</source>
        <translation>まだ開いています</translation>
    </message>
    <message>
        <source>Take it off the list</source>
        <translation>一覧から外す</translation>
    </message>
    <message>
        <source>Projects that you open will be listed here.</source>
        <translation>開いたプロジェクトがここに並びます。</translation>
    </message>
    <message>
        <source>Not there any more: {0}</source>
        <translation>もうありません：{0}</translation>
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
    <name>WorkStrip</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>actions</name>
    <message>
        <source>A few words for those who draw; the robot does not see them.</source>
        <translation>描く人のための覚え書き。ロボットには見えません。</translation>
    </message>
    <message>
        <source>A new transition of the selected state, or another target of the selected one.</source>
        <translation>選んだ状態の新しい遷移、または選んだ遷移の別の行き先。</translation>
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
        <source>Adds the states that lead to the selected ones.</source>
        <translation>選んだ状態へ向かう状態も選びます。</translation>
    </message>
    <message>
        <source>Adds the states to which the selected ones lead.</source>
        <translation>選んだ状態の行き先も選びます。</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>揃える</translation>
    </message>
    <message>
        <source>An event, tag or module gets another name in every document of the project.</source>
        <translation>イベント、タグ、モジュールの名前を、プロジェクトのすべての文書で変えます。</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>ウィンドウを閉じる</translation>
    </message>
    <message>
        <source>Connect one after the other</source>
        <translation>順につなぐ</translation>
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
        <source>English</source>
        <translation>English</translation>
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
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Export picture…</source>
        <translation>画像を書き出す…</translation>
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
        <source>Found before</source>
        <translation>前の検索結果</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>移動</translation>
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
        <source>Help</source>
        <translation>ヘルプ</translation>
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
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
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
        <source>Lower edges</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>Make a part…</source>
        <translation>部品にする…</translation>
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
        <source>New project…</source>
        <translation>新しいプロジェクト…</translation>
    </message>
    <message>
        <source>New window</source>
        <translation>新しいウィンドウ</translation>
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
        <source>Next transition of the state</source>
        <translation>状態の次の遷移</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
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
        <source>Plays a sound of the media folder.</source>
        <translation>メディアフォルダーの音を鳴らします。</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>設定…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>印刷…</translation>
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
        <source>Redo</source>
        <translation>やり直す</translation>
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
        <source>Reopen closed tab</source>
        <translation>閉じたタブを開き直す</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>配置を初期状態に戻す</translation>
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
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>コピーを保存…</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
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
        <source>Set value</source>
        <translation>値の設定</translation>
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
        <source>Shows the application that the selected state runs.</source>
        <translation>選んだ状態が動かすアプリケーションを表示します。</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>状況</translation>
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
        <source>Take from</source>
        <translation>取り出す</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>The drawing, or a part of it, as SVG, PDF or PNG.</source>
        <translation>図の全体または一部を SVG、PDF、PNG にします。</translation>
    </message>
    <message>
        <source>The graph, and beside it the screen of the selected state</source>
        <translation>グラフと、その横に選んだ状態の画面</translation>
    </message>
    <message>
        <source>The project goes into another folder as it is here, and you go on there.</source>
        <translation>今の内容でプロジェクトを別のフォルダーに保存し、そこで作業を続けます。</translation>
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
        <source>The selected cards, or all, to the nearest points of the grid.</source>
        <translation>選んだカード（なければすべて）を最も近い格子点へ。</translation>
    </message>
    <message>
        <source>The selected states become an application of their own, which one state runs.</source>
        <translation>選んだ状態を独立したアプリケーションにし、一つの状態がそれを動かします。</translation>
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
        <source>Timeout</source>
        <translation>時間切れ</translation>
    </message>
    <message>
        <source>Transition before</source>
        <translation>前の遷移</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Upper edges</source>
        <translation>上端</translation>
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
        <source>What its developer says of a module.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What leads here too</source>
        <translation>前にあるものも</translation>
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
        <source>When the selected transition may be taken.</source>
        <translation>選んだ遷移が起こってよい条件。</translation>
    </message>
    <message>
        <source>Where it leads</source>
        <translation>行き先</translation>
    </message>
    <message>
        <source>Writes a value on the blackboard.</source>
        <translation>ブラックボードに値を書き込みます。</translation>
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
    <name>kinds</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
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
        <source>A state; nothing: the state stays, only the actions are done.</source>
        <translation>状態。なければそのままで、動作だけを行います。</translation>
    </message>
    <message>
        <source>A tag that a touch sets, if any.</source>
        <translation>タッチで書き込むタグ（あれば）。</translation>
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
        <source>How traces and results call it.</source>
        <translation>トレースや結果での呼び名。</translation>
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
        <source>In words</source>
        <translation>言葉で</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>入力欄</translation>
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
        <source>Of exists: true or false.</source>
        <translation>「ある」の場合：true か false。</translation>
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
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Speech</source>
        <translation>発話</translation>
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
        <source>The event at Enter, or when it is full.</source>
        <translation>Enter を押すか、いっぱいになったときのイベント。</translation>
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
        <source>The event that a touch raises.</source>
        <translation>タッチで起こるイベント。</translation>
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
        <source>Topic</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
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
        <source>What it may ask for, such as: head base</source>
        <translation>求めてよいもの（例：head base）</translation>
    </message>
    <message>
        <source>What its developer says of a module.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What moves: base, head …</source>
        <translation>動くもの：base、head など</translation>
    </message>
    <message>
        <source>What people may say instead.</source>
        <translation>代わりに人が言える言葉。</translation>
    </message>
    <message>
        <source>What the developers of the modules say of them.</source>
        <translation>モジュールについての開発者の説明。</translation>
    </message>
    <message>
        <source>What the robot shows, says and waits for.</source>
        <translation>ロボットが見せ、話し、待つもの。</translation>
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
        <source>What “In every state” adds is part of this one too.</source>
        <translation>「すべての状態」のものがここにも加わります。</translation>
    </message>
    <message>
        <source>When done</source>
        <translation>完了したら</translation>
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
        <source>Which part of the answer goes to which tag.</source>
        <translation>答えのどの部分をどのタグに書き込むか。</translation>
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
        <source>exists</source>
        <translation>ある</translation>
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
        <source>number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>object</source>
        <translation>オブジェクト</translation>
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
        <source> of {0}</source>
        <translation>（{0}）</translation>
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
        <source>Add the situation {0}, which always holds</source>
        <translation>いつも成り立つ状況 {0} を加える</translation>
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
        <source>Let it always hold</source>
        <translation>いつも成り立つようにする</translation>
    </message>
    <message>
        <source>Let the timeout count from the end of the speech</source>
        <translation>時間切れを発話の終わりから数える</translation>
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
        <source>No text in {0} for {1}: it stays as it is written; translate it in texts/{2}.po (situ texts adds what is not there yet)</source>
        <translation>{1} の {0} の訳がありません。書かれたまま使われます。texts/{2}.po に訳を書いてください（situ texts がまだないものを加えます）</translation>
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
        <source>Only &amp;amp; &amp;lt; &amp;gt; &amp;quot; &amp;apos; and numbers such as &amp;#233; may follow &amp;</source>
        <translation>&amp; の後には &amp;amp; &amp;lt; &amp;gt; &amp;quot; &amp;apos; か &amp;#233; のような番号だけを書けます</translation>
    </message>
    <message>
        <source>Put it before event {0}</source>
        <translation>イベント {0} の前に置く</translation>
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
        <source>Several applications need a script that says which of them comes first: add spds = &quot;….spds.xml&quot; to [project]</source>
        <translation>アプリケーションが複数あるときは、どれが先かを決めるスクリプトが必要です。[project] に spds = &quot;….spds.xml&quot; を加えてください</translation>
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
        <source>The setting {0} is lost at a restart: add it to [durable]</source>
        <translation>設定 {0} は再起動で失われます。[durable] に加えてください</translation>
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
        <source>There is no texts/{0}.po, so texts stay as they are written: make it with situ texts, or take the language out</source>
        <translation>texts/{0}.po がないので、文章は書かれたまま使われます。situ texts で作るか、言語を取り除いてください</translation>
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
        <source>XML or text declaration not at start of entity</source>
        <translation>XML 宣言が先頭にありません</translation>
    </message>
    <message>
        <source>[{0}] has no key {1}; did you mean {2}?</source>
        <translation>[{0}] にキー {1} はありません。{2} のことですか？</translation>
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
        <source>at least {0}</source>
        <translation>が {0} 以上</translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>が {0} 以下</translation>
    </message>
    <message>
        <source>here and in what every state has</source>
        <translation>ここと、すべての状態に共通のところに</translation>
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
        <source> (part of every state{0}, and above what a state itself shows)</source>
        <translation>（すべての状態に共通{0}で、状態自身の表示の上に重なります）</translation>
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
        <source>Nothing leads out of the state {0}: add an event or a timeout that leads on, or say that it may end here, if that is meant</source>
        <translation>状態 {0} から出る道がありません。先へ進むイベントか時間切れを加えるか、終わりのつもりなら「ここで終わってよい」としてください</translation>
    </message>
    <message>
        <source>Only an event that leads nowhere can say again: take that out, or let the event lead nowhere</source>
        <translation>言い直しは行き先のないイベントでだけ使えます。取り除くか、イベントの行き先をなくしてください</translation>
    </message>
    <message>
        <source>Saying again cannot stand among a state&apos;s actions: put it into an event that leads nowhere, or take it out</source>
        <translation>言い直しは状態の動作としては置けません。行き先のないイベントに移すか、取り除いてください</translation>
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
        <source>in the start state there is nowhere to go back to: name a state</source>
        <translation>開始状態には戻り先がありません。状態を指定してください</translation>
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
        <source>it would have more than {0} states, because #back can lead back along ways of any length, or parts hold very many states</source>
        <translation>#back がどこまでも戻れるか、部品の状態が非常に多いため、状態が {0} 個を超えます</translation>
    </message>
    <message>
        <source>its file is {0}, was {1}</source>
        <translation>ファイルは {0}（前は {1}）</translation>
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
        <source>lie</source>
        <translation>が</translation>
    </message>
    <message>
        <source>lies</source>
        <translation>が</translation>
    </message>
    <message>
        <source>list</source>
        <translation>一覧</translation>
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
        <source>no state expects it</source>
        <translation>どの状態もそれを待っていません</translation>
    </message>
    <message>
        <source>no value can be so: {0}</source>
        <translation>そのような値はありません：{0}</translation>
    </message>
    <message>
        <source>none of the states {0} expects it</source>
        <translation>状態 {0} のどれもそれを待っていません</translation>
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
        <source>setting {0} {1}</source>
        <translation>設定 {0} {1}</translation>
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
        <source>state {0} {1}</source>
        <translation>状態 {0} {1}</translation>
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
        <source>the event resumed leaves state {0} before its screen was shown, and &lt;always&gt; has a screen</source>
        <translation>イベント resumed が画面を表示する前に状態 {0} を離れ、すべての状態に共通の画面がある</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>ファイル</translation>
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
        <source>the same start, written out or left to the first state</source>
        <translation>開始は同じで、明示したか、最初の状態に任せたかの違いだけ</translation>
    </message>
    <message>
        <source>the same state anew</source>
        <translation>同じ状態をもう一度</translation>
    </message>
    <message>
        <source>the situations that give it a priority are never current</source>
        <translation>優先度を与える状況になることがありません</translation>
    </message>
    <message>
        <source>the state is left first, as {0} without a name {1} then: give it a condition</source>
        <translation>名前のない {0} がそのとき {1} ので、状態を先に離れます。条件を付けてください</translation>
    </message>
    <message>
        <source>the timeout of every state</source>
        <translation>すべての状態に共通の時間切れ</translation>
    </message>
    <message>
        <source>whenever it could be, {0} comes first: change a condition, or their order</source>
        <translation>起こりうるときには必ず {0} が先になります。条件か順序を変えてください</translation>
    </message>
    <message>
        <source>{0} comes first, on no condition: put this one before it, or give it one</source>
        <translation>{0} が先にあり、条件がありません。これをその前に置くか、あちらに条件を付けてください</translation>
    </message>
    <message>
        <source>{0} gives {1} no priority in any situation: give it one</source>
        <translation>{0} はどの状況でも {1} に優先度を与えていません。どれかで与えてください</translation>
    </message>
    <message>
        <source>{0} is used but not observed: add it to the data observed</source>
        <translation>{0} は使われていますが観測されていません。観測するデータに加えてください</translation>
    </message>
    <message>
        <source>{0} uses {1} here but does not declare it: add it to the resources of its module</source>
        <translation>{0} はここで {1} を使いますが、宣言していません。そのモジュールのリソースに加えてください</translation>
    </message>
    <message>
        <source>{0} without waiting ({1}): let a condition fail once it was followed, or wait for a timeout or for an event from outside</source>
        <translation>待つことなく {0}（{1}）。一度たどったら条件が成り立たなくなるようにするか、時間切れか外からのイベントを待ってください</translation>
    </message>
    <message>
        <source>“Is one of” needs a list such as [&quot;a&quot;, &quot;b&quot;], not {0}</source>
        <translation>「のどれか」には {0} ではなく [&quot;a&quot;, &quot;b&quot;] のような一覧が必要です</translation>
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
        <source>{0} is no tag: {1}</source>
        <translation>{0} はタグではありません：{1}</translation>
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
        <source>{0} {1} over it, and a touch there does not reach it</source>
        <translation>{0} が{1}重なっていて、そこに触れても届きません</translation>
    </message>
    <message>
        <source>{0} {1} over it, so it cannot be read</source>
        <translation>{0} が{1}重なっていて、読めません</translation>
    </message>
    <message>
        <source>{0} {1} over the whole of it, so it is never seen</source>
        <translation>{0} が{1}全体に重なっていて、見えません</translation>
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
</TS>
