// The words of /operate, by language.

export const WORDS = {
  en: {
    title: "Operate", situation: "Situation", holds: "Holds", suspended: "Suspended: it waits for its resources", paused: "Paused", pause: "Pause", resume: "Go on", step: "Next step",
    nothing: "It expects no event.", when: "Only where {when}", back: "Nowhere to go back to", or: " or ", says: "Says here",
    more: "States and breakpoints", state: "State", go: "Go there", stop: "Stop there", stops: "Stops at {place}", unstop: "Remove", went: "Sent to {state}", stopping: "It will stop at {state}", unstopped: "Breakpoint removed",
    say: "Say", saying: "Let the robot say", spoken: "“{text}”", hush: "Be quiet", hushed: "Quiet", wordlessSay: "Type what the robot is to say",
    unspoken: "The script gives the module “operator” no priority for speech here.", busy: "{who} has the voice.", nobody: "Nobody gives the voice away now.",
    heard: "What a person said", send: "Send", data: "Data", other: "Another tag", value: "Value", set: "Set", now: "Now {value}", unset: "Not set", less: "Less", moreOf: "More",
    touch: "Touch the screen", raised: "{name} raised", said: "“{text}” sent", wrote: "{tag} set", touched: "Screen touched",
    away: "The robot is away. Try again.", tagless: "Type a tag first", wordless: "Type what was said first",
    number: "Type a number, such as 12 or 0.5", time: "Type a time, such as 08:30", date: "Type a day of the calendar",
  },
  ja: {
    title: "操作", situation: "状況", holds: "使用中", suspended: "中断中：資源を待っています", paused: "一時停止中", pause: "一時停止", resume: "再開", step: "次へ進める",
    nothing: "待っているイベントはありません。", when: "条件：{when}", back: "戻り先がありません", or: " または ", says: "ここでの発話",
    more: "状態とブレークポイント", state: "状態", go: "移動", stop: "ここで止める", stops: "{place}で止まります", unstop: "削除", went: "{state}へ移動しました", stopping: "{state}で止まります", unstopped: "ブレークポイントを削除しました",
    say: "話す", saying: "ロボットに話させる", spoken: "「{text}」", hush: "話を止める", hushed: "止めました", wordlessSay: "話す言葉を入力してください",
    unspoken: "この状況では、スクリプトがモジュール「operator」に発話の優先度を与えていません。", busy: "{who}が音声を使用しています。", nobody: "今は音声を使えません。",
    heard: "人が言ったこと", send: "送る", data: "データ", other: "ほかのタグ", value: "値", set: "設定", now: "現在：{value}", unset: "未設定", less: "減らす", moreOf: "増やす",
    touch: "画面にタッチ", raised: "{name}を送りました", said: "「{text}」を送りました", wrote: "{tag}を設定しました", touched: "画面にタッチしました",
    away: "ロボットに接続できません。もう一度お試しください。", tagless: "タグを入力してください", wordless: "言ったことを入力してください",
    number: "数字を入力してください（例：12、0.5）", time: "時刻を入力してください（例：08:30）", date: "日付を入力してください",
  },
  de: {
    title: "Bedienen", situation: "Situation", holds: "Hält", suspended: "Unterbrochen: wartet auf ihre Ressourcen", paused: "Angehalten", pause: "Anhalten", resume: "Weiter", step: "Nächster Schritt",
    nothing: "Erwartet kein Ereignis.", when: "Nur wenn {when}", back: "Kein Zustand, zu dem es zurückgeht", or: " oder ", says: "Sagt hier",
    more: "Zustände und Haltepunkte", state: "Zustand", go: "Dorthin", stop: "Dort anhalten", stops: "Hält bei {place}", unstop: "Entfernen", went: "Nach {state} geschickt", stopping: "Hält bei {state}", unstopped: "Haltepunkt entfernt",
    say: "Sagen", saying: "Den Roboter sagen lassen", spoken: "„{text}“", hush: "Still sein", hushed: "Still", wordlessSay: "Bitte eingeben, was der Roboter sagen soll",
    unspoken: "Das Skript gibt dem Modul „operator“ hier keine Priorität für Sprache.", busy: "{who} hat die Stimme.", nobody: "Die Stimme ist jetzt nicht zu haben.",
    heard: "Was jemand gesagt hat", send: "Senden", data: "Daten", other: "Ein anderer Tag", value: "Wert", set: "Setzen", now: "Jetzt {value}", unset: "Nicht gesetzt", less: "Weniger", moreOf: "Mehr",
    touch: "Bildschirm berühren", raised: "{name} ausgelöst", said: "„{text}“ gesendet", wrote: "{tag} gesetzt", touched: "Bildschirm berührt",
    away: "Der Roboter ist nicht erreichbar. Bitte noch einmal versuchen.", tagless: "Bitte erst einen Tag eingeben", wordless: "Bitte erst eingeben, was gesagt wurde",
    number: "Bitte eine Zahl eingeben, etwa 12 oder 0,5", time: "Bitte eine Uhrzeit eingeben, etwa 08:30", date: "Bitte einen Tag des Kalenders eingeben",
  },
};
