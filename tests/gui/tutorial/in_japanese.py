"""What docs/tutorial.ja.md says where docs/tutorial.md says it in English: pressed, and typed."""

from __future__ import annotations

STUDIO = {
    "New project": "新しいプロジェクト",
    "Drawing": "図",
    "Project": "プロジェクト",
    "Name": "名前",
    "It may end here": "ここで終わってよい",
    "Speech Hello": "発話 こんにちは",
    "Says": "話すこと",
    "Button": "ボタン",
    "Screen": "画面",
    "Graph": "グラフ",
    "state": "状態",
    "Text": "文字",
    "Speech": "発話",
    "Service": "サービス",
    "Add a value": "値を加える",
    "Add a result": "結果を加える",
    "When done": "完了したら",
    "If it fails": "失敗したら",
    "Event": "イベント",
    "Add a test": "条件を加える",
    "A test": "条件",
    "Test": "比べ方",
    "at most": "以下",
    "Value": "値",
    "Timeout": "時間切れ",
    "The timeout leads to": "時間切れの行き先",
    "Add a Repeat button to every state": "すべての状態に「もう一度」ボタンを加える",
    "Script of situations": "状況のスクリプト",
    "Data": "データ",
    "Module": "モジュール",
    "Resources": "リソース",
    "texts": "文字",
    "Add a language…": "言語を追加…",
    "Rehearse": "リハーサル",
    "The robot's screen": "ロボットの画面",
    "What Service measure answers": "サービス measure の答え",
    "Save as a scenario": "シナリオとして保存",
    "Scenarios": "シナリオ",
    "Run all": "すべて実行",
    "Paint": "図に表示",
    "0 errors": "エラー 0 件",
    "0 warnings": "警告 0 件",
}
"""What is pressed, and what it is beside."""

TEXTS = {
    "Repeat": "もう一度",
    "START": "はじめる",
    "Put the cuff on your left arm, please. Then touch start.": (
        "左腕にカフを巻いてください。それから「はじめる」に触れてください。"
    ),
    "Blood pressure": "血圧",
    "Hold still, please.": "動かないでください。",
    "STOP": "やめる",
    "I am measuring. Please hold still.": "測っています。動かないでください。",
    "{bp.systolic} over {bp.diastolic}": "上 {bp.systolic}、下 {bp.diastolic}",
    "DONE": "おわり",
    "Your blood pressure is {bp.systolic} over {bp.diastolic}. That is good.": (
        "血圧は上が{bp.systolic}、下が{bp.diastolic}です。いつもどおりです。"
    ),
    "Please stay seated. Your nurse looks at it with you.": (
        "座ってお待ちください。看護師が見ます。"
    ),
}
"""What the robot shows and says, as the last column of its table of texts has them."""

NAMES = {
    "ready": "待機",
    "measuring": "測定中",
    "as usual": "いつもどおり",
    "call the nurse": "看護師を呼ぶ",
    "stopped": "停止",
    "high pressure": "高い血圧",
    "1 start": "1 はじめ",
    "1 ready": "1 待機",
    "2 measuring": "2 測定中",
    "3 as usual": "3 いつもどおり",
    "4 call the nurse": "4 看護師を呼ぶ",
    "event4 4 call the nurse": "event4 4 看護師を呼ぶ",
    "measured 3 as usual": "measured 3 いつもどおり",
}
"""What a person calls states, situations and scenarios, and how the editor writes them."""

HEADINGS = {
    "Begin a project": "プロジェクトを作る",
    "The first state": "最初の状態",
    "Its screen": "画面",
    "A state that follows": "次の状態",
    "Ask the cuff": "カフに頼む",
    "Where it leads": "行き先",
    "A limit": "境目の値",
    "What the robot answers": "ロボットの答え",
    "Nobody is there, or has not understood": "だれもいないとき、聞き取れなかったとき",
    "What stops the robot": "ロボットを止めるもの",
    "In Japanese too": "英語でも",
    "Try it": "試す",
    "Keep it as a test": "テストとして残す",
}

WORDS = {**STUDIO, **TEXTS, **NAMES, **HEADINGS}
