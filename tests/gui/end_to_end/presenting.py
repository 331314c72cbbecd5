"""The part of a session that comes after designing: a walk, pictures by day and by night, the gallery, furniture of
one's own, and a film of two seconds."""
import math
import struct
import time

from program_session import Failed, HEIGHT, WIDTH, expect, place_by_keys

IN_LIVE_VIEW = (WIDTH // 2, HEIGHT * 2 // 5)


def walk(session):
    """Ahead in the live view, keeping where one stood and where one came to."""
    session.focus_main()
    session.keys("ctrl+4")
    time.sleep(1)
    session.click(IN_LIVE_VIEW)
    session.keys("ctrl+b")
    session.hold("s", 0.6)
    session.keys("ctrl+b")
    time.sleep(2)
    session.shoot("walked")
    views = session.content(session.save_as("walked.idap"))["cameras"]
    expect("points of view kept", len(views), 2)
    start, end = (view["eye"] for view in views)
    way = math.dist(start, end)
    if not 0.3 < way < 2:
        raise Failed(f"walked {way:.2f} m in 0.6 s")
    expect("eye height while walking", round(end[2], 3), round(start[2], 3))


def ray_trace(session, count):
    session.keys("alt+r")

    for attempt in range(30):
        time.sleep(1)
        pictures = session.content(session.save_as(f"pictures-{count}-{attempt}.idap")).get("pictures", [])
        session.focus("Pictures")
        if len(pictures) == count:
            return pictures
    raise Failed(f"picture {count} is not in the gallery")


def day_and_night(session):
    session.focus_main()
    session.keys("F4")
    session.focus("Pictures")
    session.keys("alt+i", "Home", "alt+q", "Home")
    day = ray_trace(session, 1)[0]
    session.shoot("day")
    file = session.folder / "day.png"
    session.keys("alt+s")
    session.choose_file("Save picture", file)
    session.wait(file.exists, "the picture's file")
    time.sleep(0.3)
    expect("size of the picture", struct.unpack(">II", file.read_bytes()[16:24]), (320, 200))

    session.focus("Pictures")
    session.keys("alt+t")
    time.sleep(0.5)  # the box shows itself pressed for a moment before the field can be reached
    session.keys("Tab", "Tab", "Tab", "Tab")  # to the hour
    session.type("23")
    night = ray_trace(session, 2)[1]
    session.shoot("night")
    view = night["settings"]["view"]
    expect("hour of the night picture (UTC)", view["time"] // 3_600_000 % 24, 23)
    expect("the night is the day's place", view["eye"], day["settings"]["view"]["eye"])
    session.keys("alt+c")
    time.sleep(0.5)
    session.keys("Down", "Return")
    time.sleep(0.5)
    session.shoot("compared")


def own_furniture(session):
    session.focus_main()
    session.keys("ctrl+0")
    place_by_keys(session, "night table")  # is selected then
    session.keys("alt+u", "s")
    session.focus("Save as furniture")
    session.keys("alt+n", "ctrl+a")
    session.type("Grandmother chest")
    library = session.folder / "data" / "idap" / "furniture" / "own-furniture.sh3f"

    def saved():  # the button waits for the piece to be made
        if session.windows("Save as furniture"):
            session.keys("Return")
        return library.exists()

    session.wait(saved, "the own furniture to be saved")
    session.wait(lambda: not session.windows("Save as furniture"), "the dialog to close")
    session.focus_main()
    place_by_keys(session, "grandmother")
    time.sleep(0.5)
    session.shoot("own_furniture")
    home = session.save_as("own.idap")
    pieces = session.content(home)["furniture"]
    own = [piece for piece in pieces if piece["model"].get("catalogId", "").startswith("own/")]
    expect("own pieces placed", [piece["name"] for piece in own], ["Grandmother chest"])
    library.unlink()  # the home is whole without it
    expect("what the saved home lacks", session.warnings(home), "")


def seconds_of(film):
    """The length that an MP4's header (mvhd, version 0) says."""
    at = film.find(b"mvhd")
    scale, length = struct.unpack(">II", film[at + 16:at + 24])
    return length / scale


def film(session):
    file = session.folder / "day.mp4"
    session.focus_main()
    session.keys("shift+F4")
    session.focus("Film")
    session.keys("alt+f", "Down", "alt+e", "ctrl+a")
    session.type("2")
    session.keys("alt+i", "Home", "alt+a", "ctrl+a")
    session.type("5")
    session.keys("alt+q", "Home", "alt+m")
    session.choose_file("Make the film", file)
    time.sleep(2)
    session.shoot("film")
    session.wait(lambda: file.exists() and b"mvhd" in file.read_bytes(), "the film", 120)
    length = seconds_of(file.read_bytes())
    if abs(length - 2) > 0.01:
        raise Failed(f"the film lasts {length} s, not 2")


def see_and_show(session):
    walk(session)
    day_and_night(session)
    own_furniture(session)
    film(session)
