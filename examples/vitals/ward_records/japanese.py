"""The nurse's page in Japanese: text as written to what stands there."""

from __future__ import annotations

JAPANESE = {
    "Ward": "病棟",
    "Resident": "入居者",
    "Residents": "入居者",
    "Calls": "呼び出し",
    "Your token": "トークン",
    "Open": "開く",
    "There is no such token.": "このトークンは登録されていません。",
    "Room": "部屋",
    "room {0}": "{0}号室",
    "Room {0}": "{0}号室",
    "place not known": "場所は不明",
    "the robot": "ロボットの所",
    "Name": "名前",
    "Measured": "測定値",
    "Measured last": "最後の測定値",
    "When": "日時",
    "What": "種類",
    "Nothing has been measured yet.": "まだ測定されていません。",
    "Limits": "基準値",
    "Outside of these the robot measures again, and then calls you.": (
        "この範囲を外れると、ロボットはもう一度測定し、それから看護師を呼びます。"
    ),
    "Save": "保存",
    "Not saved: {0}": "保存できませんでした：{0}",
    "Nobody has called.": "呼び出しはありません。",
    "seen": "確認済み",
    "I am going": "向かいます",
    "With this token private data are not shown.": ("このトークンでは個人の情報は表示されません。"),
    "outside of the limits": "基準値を外れています",
    "pulse": "脈拍",
    "{0} of 5": "5問中{0}問正解",
    "Systolic, lower limit, mmHg": "最高血圧の下限（mmHg）",
    "Systolic, upper limit, mmHg": "最高血圧の上限（mmHg）",
    "Diastolic, lower limit, mmHg": "最低血圧の下限（mmHg）",
    "Diastolic, upper limit, mmHg": "最低血圧の上限（mmHg）",
    "Oxygen, lower limit, %": "酸素飽和度の下限（%）",
    "Glucose, lower limit, mmol/L": "血糖値の下限（mmol/L）",
    "Glucose, upper limit, mmol/L": "血糖値の上限（mmol/L）",
    "Blood pressure": "血圧",
    "Blood oxygen": "酸素飽和度",
    "Blood glucose": "血糖値",
    "Brain game": "脳トレ",
    "dashed: the limits": "破線は基準値",
    "{0}: {1} readings, the last one {2}": "{0}：{1}回の測定、最後は{2}",
    "All readings as a table (CSV)": "すべての測定値を表で保存（CSV）",
    "Readings as a table (CSV)": "測定値を表で保存（CSV）",
    "Add a resident": "入居者を追加",
    "Add": "追加",
    "PIN, four digits": "暗証番号（数字4桁）",
    "New PIN; empty: as it is": "新しい暗証番号（空欄なら変わりません）",
    "Save resident": "入居者を保存",
    "Medicine, and what is told today": "薬と今日の予定",
    "The robot is with somebody": "ロボットがそばにいます",
    "With somebody": "見守り中",
    "Look": "見る",
    "Today": "今日",
    "Medicine": "薬",
    "Round": "時間帯",
    "Morning": "朝",
    "Noon": "昼",
    "Evening": "夕方",
    "–": "–",
    "taken": "服用済み",
    "not taken": "服用していません",
    "nobody answered": "返事がありません",
    "no way there": "行けませんでした",
    "told": "伝えました",
    "told again later": "あとでもう一度伝えます",
    "Nobody is given anything.": "薬の予定はありません。",
    "What the robot tells": "ロボットが伝えること",
    "At": "時刻",
    "For": "相手",
    "Message": "内容",
    "Nothing is to be told today.": "今日伝えることはありません。",
    "all": "全員",
    "all, where the robot is": "ロボットの近くにいる全員",
    "Remove": "削除",
    "Have the robot tell": "ロボットに伝えてもらう",
    "Not added: {0}": "追加できませんでした：{0}",
    "every day": "毎日",
    "As the robot is to say it, with how to take it. Empty: nothing then.": (
        "ロボットが話すとおりに、飲み方も入れてください。空欄なら何も渡しません。"
    ),
    "Save medicine": "薬を保存",
    "What the robot sees": "ロボットが見ているもの",
    "The robot has said that a nurse sees them. It stays until you or they let it go.": (
        "看護師が見ていることをロボットが伝えました。"
        "あなたか本人が終えるまで、ロボットはそばにいます。"
    ),
    "Help is there": "助けが来ました",
    "The robot shows nothing now.": "ロボットは今、何も映していません。",
    "Camera": "カメラ",
    "Whom they may call": "電話をかけられる相手",
    "Family": "ご家族",
    "Friends": "お友達",
    "Group": "間柄",
    "Address": "連絡先",
    "Address of the video program": "ビデオ通話の連絡先",
    "Add contact": "相手を追加",
    "Remove this resident": "この入居者を削除",
    "Remove {0}, room {1}?": "{1}号室の{0}様を削除しますか。",
    "Remove {0}": "{0}様を削除",
    "No, go back": "やめて戻る",
    (
        "The robot then knows this person no more: nobody logs in with their PIN, and whoever is "
        "logged in is logged out. Medicine, messages and contacts are taken away, and a round that "
        "is under way passes by."
    ): (
        "ロボットはこの方がわからなくなります。暗証番号は使えなくなり、利用中であれば終了します。"
        "薬、お知らせ、連絡先は消去され、巡回中のロボットもこの方を訪ねません。"
    ),
    "who lived there has moved out: this goes once you have seen it": (
        "お住まいだった方は退去済みです。確認すると消えます"
    ),
    "What was measured: {0} readings": "測定値：{0}件",
    "Keep them, with name and room, until you take them away.": (
        "名前と部屋とともに残す（あとで消去できます）"
    ),
    "Take them away now, for ever.": "今すぐ消去する（元に戻せません）",
    "Who has moved out": "退去された方",
    "Moved out": "退去",
    "Of these the readings were kept.": "次の方の測定値が残っています。",
    "Of nobody.": "残っている測定値はありません。",
    "Table (CSV)": "表で保存（CSV）",
    "Take them away": "消去",
    "Take away what was measured of {0}?": "{0}様の測定値を消去しますか。",
    "Name and room go with it. Nobody gets it back.": (
        "名前と部屋も消去されます。元には戻せません。"
    ),
    "Take it away for ever": "消去する",
    # What is wrong with what was given.
    "an address has no blanks and begins with a letter, a digit or +": (
        "連絡先は空白を含まず、英字、数字または+で始まります"
    ),
    "Another nurse has changed this meanwhile:": "ほかの看護師がその間に変更しました：",
    "What you typed stands here still. Save once more, and it replaces that.": (
        "入力した内容はそのまま残っています。もう一度保存すると、入力した内容に変わります。"
    ),
    "family or friends": "ご家族かお友達を選んでください",
    "The robot can not read {0}: type behind it how it is said, as in 錠剤（じょうざい）.": (
        "ロボットは{0}を読めません。錠剤（じょうざい）のように、後ろに読みを付けてください。"
    ),
    "Saved.": "保存しました。",
    "Remove {0}?": "「{0}」を削除しますか。",
    "How the name is said, in kana": "お名前の読み（かな）",
    "the robot can not read {0}: type in kana how the name is said": (
        "ロボットは「{0}」を読めません。お名前の読みをかなで入れてください"
    ),
    "how the name is said: hiragana or katakana only": (
        "お名前の読みは、ひらがなかカタカナで入れてください"
    ),
    "a name has 1 to 80 letters": "名前は1文字から80文字です",
    "a PIN is four digits": "暗証番号は数字4桁です",
    "somebody in this room has this PIN already": "この暗証番号は同じ部屋の方がすでに使っています",
    "a time as 15:30, and what there is then": "時刻（15:30のように）と内容を入れてください",
    "somebody lives in room {0}: give a new PIN, too": (
        "{0}号室にはほかの方がいます。新しい暗証番号も入れてください"
    ),
    "the room must be a number": "部屋は数字で入れてください",
    "{0}: the lower limit below the upper, {1} to {2}": (
        "{0}：下限は上限より低く、{1}から{2}までです"
    ),
    "systolic": "最高血圧",
    "diastolic": "最低血圧",
    "oxygen": "酸素飽和度",
    "glucose": "血糖値",
    # Why somebody is called, as the robot says it in English.
    "fall": "転倒",
    "help": "助けを求めています",
    "help at night": "夜間に助けを求めています",
    "blood pressure": "血圧が基準値を外れています",
    "blood oxygen": "酸素飽和度が基準値を外れています",
    "low blood sugar": "血糖値が低い",
    "high blood sugar": "血糖値が高い",
    "medicine not taken, three times": "薬を3回飲んでいません",
    "the clip does not measure": "指の測定器が測れません",
    "the cuff does not measure": "血圧計が測れません",
    "wants to talk": "話したがっています",
}
