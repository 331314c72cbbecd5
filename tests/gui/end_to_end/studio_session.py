#!/usr/bin/env python3
"""The real program on a display of its own, used as a person does, with keys and mouse: a new room, ten pieces, a door
and a window, undo all, redo all, save, reopen, print, quit. What was saved is judged by `idap info`.

    studio_session.py BIN_FOLDER

Exit status 0: all went well; 77: Xvfb or xdotool is missing, nothing was tried; else what went wrong is said.
IDAP_SHOTS=FOLDER keeps pictures of the screen, where ImageMagick is there to take them.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
WIDTH, HEIGHT = 1280, 800
# What is typed into the catalog's search, Enter placing the first piece found.
PIECES = ["double bed", "night table", "night table", "wardrobe", "vanity", "table lamp", "armchair", "bookshelf"]
DRAGGED = ["plant", "chair"]  # these by the mouse


class Failed(Exception):
    pass


class Display:
    """An Xvfb of our own, on a number that it finds free itself."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.name = ":" + numbers.readline().strip()
        if self.name == ":":
            raise Failed("Xvfb did not start")

    def close(self):
        self.server.terminate()
        self.server.wait(10)


class Session:
    def __init__(self, folder, binaries, display):
        self.folder, self.binaries = folder, binaries
        self.environment = dict(os.environ, DISPLAY=display, QT_QPA_PLATFORM="xcb", LC_ALL="C.UTF-8", LANG="C.UTF-8",
                                HOME=str(folder), IDAP_FURNITURE="")
        for name in ("WAYLAND_DISPLAY", "QT_SCALE_FACTOR", "QT_STYLE_OVERRIDE", "LANGUAGE"):
            self.environment.pop(name, None)
        for name in ("CONFIG", "DATA", "CACHE", "STATE"):
            self.environment[f"XDG_{name}_HOME"] = str(folder / name.lower())
        self.program = self.main = None
        self.shots = 0

    def start(self, *arguments):
        self.program = subprocess.Popen([str(self.binaries / "idap"), *arguments], env=self.environment, cwd=self.folder)

    def xdotool(self, *words):
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True)

    def windows(self, title):
        found = self.xdotool("search", "--onlyvisible", "--name", title)
        return found.stdout.split()

    def wait(self, condition, what, seconds=20):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.program and self.program.poll() is not None:
                raise Failed(f"the program ended with {self.program.returncode} while waiting for {what}")
            result = condition()
            if result:
                return result
            time.sleep(0.05)
        self.shoot("failed")
        raise Failed(f"waited in vain for {what}")

    def focus(self, title):
        """Brings the keyboard to the window of that title: there is no window manager to do it."""
        window = self.wait(lambda: self.windows(title), f"the window '{title}'")[-1]
        self.xdotool("windowfocus", "--sync", window)
        time.sleep(0.15)
        return window

    def focus_main(self):
        self.xdotool("windowfocus", "--sync", self.main)
        time.sleep(0.15)

    def keys(self, *names):
        for name in names:
            self.xdotool("key", "--clearmodifiers", name)
            time.sleep(0.06)

    def type(self, text):
        self.xdotool("type", "--delay", "8", text)
        time.sleep(0.1)

    def drag(self, start, end):
        self.xdotool("mousemove", *start)
        self.xdotool("mousedown", 1)
        steps = 12
        for i in range(1, steps + 1):
            self.xdotool("mousemove", *(round(a + (b - a) * i / steps) for a, b in zip(start, end)))
            time.sleep(0.02)
        time.sleep(0.1)
        self.xdotool("mouseup", 1)
        time.sleep(0.2)

    def click(self, at):
        self.xdotool("mousemove", *at)
        self.xdotool("click", 1)
        time.sleep(0.15)

    def save_as(self, name):
        file = self.folder / name
        self.focus_main()
        self.keys("ctrl+shift+s")
        self.focus("Save the home as")
        self.keys("ctrl+a")
        self.type(str(file))
        self.keys("Return")
        self.wait(file.exists, f"{name} to be written")
        self.wait(lambda: not self.windows("Save the home as"), "the save dialog to close")
        return file

    def info(self, file):
        done = subprocess.run([str(self.binaries / "idap"), "info", "--json", str(file)], env=self.environment,
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise Failed(f"{file.name} cannot be read: {done.stderr}")
        return json.loads(done.stdout)

    def shoot(self, name):
        folder = os.environ.get("IDAP_SHOTS")
        if not folder or not shutil.which("import"):
            return
        self.shots += 1
        subprocess.run(["import", "-window", "root", f"{folder}/session_{self.shots:02d}_{name}.png"],
                       env=self.environment)

    def end(self):
        if self.program and self.program.poll() is None:
            self.program.send_signal(signal.SIGKILL)
            self.program.wait()


def expect(what, found, wanted):
    if found != wanted:
        raise Failed(f"{what}: {found}, not {wanted}")


def place_by_keys(session, words):
    session.keys("ctrl+f", "ctrl+a")
    session.type(words)
    session.keys("Return")


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
