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
    # What is wrong with what was given.
    "a name has 1 to 80 letters": "名前は1文字から80文字です",
    "a PIN is four digits": "暗証番号は数字4桁です",
    "somebody in this room has this PIN already": "この暗証番号は同じ部屋の方がすでに使っています",
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
}
