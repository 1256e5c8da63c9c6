"""What docs/adding-an-effect.md shows of the sample's files must be what they say. Usage: page_test.py DOCS"""

import re
import sys
from pathlib import Path

docs = Path(sys.argv[1])
page = (docs / "adding-an-effect.md").read_text(encoding="utf-8")
files = [path.read_text(encoding="utf-8") for path in (docs / "adding-an-effect").iterdir()]
shown = [text for text in re.findall(r"```cpp\n(.*?)```", page, re.DOTALL) if not text.startswith(" ")]
other = [text for text in shown if not any(text in file for file in files)]
if len(shown) < 3 or other:
    sys.exit(f"{len(shown)} parts of files are shown; in none of the files is:\n" + "\n".join(other))
