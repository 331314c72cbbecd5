"""A display of its own with the real program on it, driven by keys and mouse as a person does."""
import json
import os
import shutil
import signal
import subprocess
import time
import zipfile

SKIPPED = 77
WIDTH, HEIGHT = 1280, 800


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

    def warnings(self, file):
        """What is said of a home while it is built."""
        picture = ["render", str(file), "-o", str(self.folder / "tiny.png"), "--size", "32x20", "--spp", "1"]
        return subprocess.run([str(self.binaries / "idap"), *picture], env=self.environment, capture_output=True,
                              text=True).stderr

    def content(self, file):
        """What an .idap says of the home."""
        with zipfile.ZipFile(file) as archive:
            return json.loads(archive.read("home.json"))

    def choose_file(self, title, file):
        """Answers a file dialog and waits for the file."""
        self.focus(title)
        self.keys("ctrl+a")
        self.type(str(file))
        self.keys("Return")
        return file

    def hold(self, key, seconds):
        self.xdotool("keydown", key)
        time.sleep(seconds)
        self.xdotool("keyup", key)
        time.sleep(0.1)

    def shoot(self, name):
        folder = os.environ.get("IDAP_SHOTS")
        if not folder or not shutil.which("import"):
            return
        self.shots += 1
        subprocess.run(["import", "-window", "root", f"{folder}/session_{self.shots:02d}_{name}.png"],
                       env=self.environment)

    def keep(self):
        """Beside the pictures of the screen, what the session made."""
        folder = os.environ.get("IDAP_SHOTS")
        for file in self.folder.iterdir() if folder else ():
            if file.suffix in (".pdf", ".png", ".mp4", ".idap"):
                shutil.copy(file, folder)

    def end(self):
        self.keep()
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
