#!/usr/bin/env python3
"""The real program on a display of its own, used as a person does, with keys and mouse: a new room, ten pieces, a door
and a window, undo all, redo all, save, reopen, print; then a walk, pictures by day and by night, furniture of one's own
and a film; quit. What was saved is judged by `idap info` and by the files themselves.

    studio_session.py BIN_FOLDER

Exit status 0: all went well; 77: Xvfb or xdotool is missing, nothing was tried; else what went wrong is said.
IDAP_SHOTS=FOLDER keeps what it made, and pictures of the screen where ImageMagick is there to take them.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import presenting
from program_session import SKIPPED, Display, Failed, Session, expect, place_by_keys

# What is typed into the catalog's search, Enter placing the first piece found.
PIECES = ["double bed", "night table", "night table", "wardrobe", "vanity", "table lamp", "armchair", "bookshelf"]
DRAGGED = ["plant", "chair"]  # these by the mouse


def place_by_mouse(session, words, at):
    session.keys("ctrl+f", "ctrl+a")
    session.type(words)
    time.sleep(0.4)
    session.drag(FIRST_IN_CATALOG, at)


FIRST_IN_CATALOG = (58, 400)
DROPS = [(480, 230), (650, 260)]


def use(session):
    session.start()
    session.main = session.focus("Welcome")
    session.shoot("welcome")
    # The first field has the keyboard.
    for size in ("5m", "4m", "2.5m"):
        session.keys("ctrl+a")
        session.type(size)
        session.keys("Tab")
    session.keys("Return")
    session.wait(lambda: session.windows("New home"), "the new room")
    session.focus_main()
    time.sleep(0.5)
    empty = session.save_as("empty.idap")
    room = session.info(empty)
    expect("walls of the new room", room["walls"], 4)
    expect("rooms", room["rooms"], 1)
    expect("pieces of the new room", room["pieces"], 0)

    session.focus_main()
    for words in PIECES:
        place_by_keys(session, words)
    for words, at in zip(DRAGGED, DROPS):
        place_by_mouse(session, words, at)
    for words in ("panelled door", "casement window"):
        place_by_keys(session, words)
    session.shoot("furnished")
    furnished = session.save_as("furnished.idap")
    counts = session.info(furnished)
    expect("openings", counts["openings"], 2)
    expect("pieces with door and window", counts["pieces"], len(PIECES) + len(DRAGGED) + 2)

    session.focus_main()
    steps = len(PIECES) + len(DRAGGED) + 2
    session.keys(*["ctrl+z"] * (steps + 3))
    session.shoot("undone")
    undone = session.save_as("undone.idap")
    expect("after undoing all", session.info(undone)["pieces"], 0)
    expect("the home after undoing all is the empty one", undone.read_bytes() == empty.read_bytes(), True)

    session.focus_main()
    session.keys(*["ctrl+shift+z"] * (steps + 3))
    redone = session.save_as("redone.idap")
    expect("the home after redoing all is the furnished one", redone.read_bytes() == furnished.read_bytes(), True)

    session.focus_main()
    session.keys("ctrl+w")
    time.sleep(0.3)
    session.keys("ctrl+o")
    session.focus("Open a home")
    session.keys("ctrl+a")
    session.type(str(furnished))
    session.keys("Return")
    session.wait(lambda: session.windows("furnished"), "the home to open again")
    session.shoot("reopened")
    again = session.save_as("again.idap")
    expect("the home opened and saved again is the same", again.read_bytes() == furnished.read_bytes(), True)

    plan = session.folder / "plan.pdf"
    session.focus_main()
    session.keys("ctrl+p")
    session.focus("Print")
    session.keys("alt+s")
    session.type("1:50")
    session.shoot("print")
    session.keys("alt+d")
    session.focus("Save as PDF")
    session.keys("ctrl+a")
    session.type(str(plan))
    session.keys("Return")
    session.wait(plan.exists, "the plan to be printed")
    if shutil.which("pdftotext"):
        text = subprocess.run(["pdftotext", "-layout", str(plan), "-"], capture_output=True, text=True).stdout
        expect("the print says its scale", "Scale 1:50" in text, True)

    presenting.see_and_show(session)

    session.focus_main()
    session.keys("ctrl+q")
    try:
        status = session.program.wait(10)
    except subprocess.TimeoutExpired:
        session.shoot("not_quit")
        raise Failed("the program does not quit") from None
    expect("exit status", status, 0)
    left = list((session.folder / "data" / "idap" / "recovery").glob("*.idap"))
    expect("copies left for a crash that was none", left, [])


def main():
    missing = [name for name in ("Xvfb", "xdotool") if not shutil.which(name)]
    if missing:
        print("skipped: not installed: " + ", ".join(missing))
        return SKIPPED
    binaries = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="idap-session-") as name:
        session = display = None
        try:
            display = Display()
            session = Session(pathlib.Path(name), binaries, display.name)
            use(session)
        except Failed as failure:
            print(f"failed: {failure}")
            return 1
        finally:
            if session:
                session.end()
            if display:
                display.close()
    print("the session went well")
    return 0


if __name__ == "__main__":
    sys.exit(main())
