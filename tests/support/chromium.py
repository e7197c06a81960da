"""Headless Chromium for the tests, driven over its debugging pipe: nothing but the browser needed.

The protocol is the browser's own (Chrome DevTools Protocol): JSON, each message ended by a zero
byte, read by the browser on descriptor 3 and written on 4. Time limits are on every answer.
"""

from __future__ import annotations

import base64
import json
import os
import select
import shutil
import signal
import subprocess
import time
from collections import deque
from pathlib import Path
from typing import Any

NAMES = ("chromium", "chromium-browser", "google-chrome")
# Drawing without a graphics card on a busy machine is slow.
ANSWER_S = 180.0
# Software drawing, so that it is the same on every machine; no talk with anybody.
FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--mute-audio",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-default-apps", "--disable-extensions", "--disable-dev-shm-usage",
    "--force-device-scale-factor=1", "--hide-scrollbars", "--remote-debugging-pipe",
)  # fmt: skip


def find() -> str:
    """The browser's path; RuntimeError where there is none."""
    for name in NAMES:
        if path := shutil.which(name):
            return path
    raise RuntimeError("no Chromium: apt-get install chromium")


class Browser:
    """One process, in a profile folder of its own; a context manager."""

    def __init__(self, profile: Path) -> None:
        to_browser, self._out = os.pipe()
        self._in, from_browser = os.pipe()
        # The shell gives the pipes the two numbers that the browser expects.
        command = f'exec "$@" 3<&{to_browser} 4>&{from_browser}'
        self._log = (profile.parent / f"{profile.name}.log").open("wb")
        self._process = subprocess.Popen(
            ["bash", "-c", command, "sh", find(), *FLAGS, f"--user-data-dir={profile}"],
            pass_fds=(to_browser, from_browser), stdout=self._log, stderr=self._log,
            start_new_session=True,
        )  # fmt: skip
        os.close(to_browser)
        os.close(from_browser)
        self._buffer = b""
        self._next = 0
        self.events: deque[dict[str, Any]] = deque()

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_: object) -> None:
        # The process group is this browser's alone.
        os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        os.close(self._in)
        os.close(self._out)
        self._log.close()

    def call(self, method: str, session: str | None = None, **params: Any) -> dict[str, Any]:
        """Send a command and wait for its answer."""
        self._next += 1
        message = {"id": self._next, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self._out, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + ANSWER_S
        while True:
            answer = self._read(deadline)
            if answer.get("id") == self._next:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def listen(self, seconds: float) -> None:
        """Take in events for a while."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            try:
                self.events.append(self._read(deadline))
            except TimeoutError:
                return

    def _read(self, deadline: float) -> dict[str, Any]:
        while b"\0" not in self._buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._in], [], [], left)[0]:
                raise TimeoutError("the browser does not answer")
            chunk = os.read(self._in, 1 << 20)
            if not chunk:
                raise RuntimeError(f"the browser ended; see {self._log.name}")
            self._buffer += chunk
        raw, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(raw)

    def open(self, path: Path, width: int, height: int, **options: Any) -> Page:
        """A new tab on a file, of this size in CSS pixels, once the page says that it is ready."""
        return Page(self, path, width, height, **options)


class Page:
    """One tab.

    Attributes:
        requests: addresses asked for, the page itself first.
        troubles: errors and warnings that the page caused, in words.
    """

    def __init__(
        self, browser: Browser, path: Path, width: int, height: int, *,
        phone: bool = False, dark: bool = False, scripts: bool = True, before: str = "",
    ) -> None:  # fmt: skip
        self._browser = browser
        self.requests: list[str] = []
        self.troubles: list[str] = []
        self._target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        attached = browser.call("Target.attachToTarget", targetId=self._target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=height, deviceScaleFactor=2 if phone else 1, mobile=phone,
        )  # fmt: skip
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[scheme])
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        self.call("Page.addScriptToEvaluateOnNewDocument", source=before)
        self.call("Page.navigate", url=path.resolve().as_uri())
        self._scripts = scripts
        loaded = "location.href !== 'about:blank' && document.readyState === 'complete'"
        self.wait("document.documentElement?.dataset.ready === 'true'" if scripts else loaded)
        self.settle()

    def close(self) -> None:
        self._browser.call("Target.closeTarget", targetId=self._target)

    def call(self, method: str, **params: Any) -> dict[str, Any]:
        answer = self._browser.call(method, self._session, **params)
        self._sort_events()
        return answer

    def run(self, expression: str) -> object:
        """The value of a JavaScript expression; a promise is waited for."""
        found = self.call(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        if "exceptionDetails" in found:
            raise RuntimeError(json.dumps(found["exceptionDetails"]))
        return found["result"].get("value")

    def wait(self, condition: str, seconds: float = ANSWER_S) -> None:
        """Until the expression holds; TimeoutError where it does not."""
        deadline = time.monotonic() + seconds
        while not self.run(condition):
            if time.monotonic() > deadline:
                raise TimeoutError(f"{condition}; troubles: {self.troubles}")
            time.sleep(0.05)

    def settle(self) -> None:
        """Let whatever was asked for be drawn."""
        frames = "new Promise(f => requestAnimationFrame(() => requestAnimationFrame(() => f(1))))"
        if self._scripts:
            self.run(frames)
        self._browser.listen(0.15)
        self._sort_events()

    def press(self, key: str, *, code: str = "", shift: bool = False) -> None:
        """A key with its text."""
        text = key if len(key) == 1 else ""
        common = {"key": key, "code": code or key, "modifiers": 8 if shift else 0}
        kind = "keyDown" if text else "rawKeyDown"
        codes = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Home": 36,
                 "End": 35, "Tab": 9, "Enter": 13, " ": 32}  # fmt: skip
        number = codes.get(key, ord(key.upper()) if text else 0)
        self.call(
            "Input.dispatchKeyEvent", type=kind, text=text, windowsVirtualKeyCode=number, **common
        )
        self.call("Input.dispatchKeyEvent", type="keyUp", windowsVirtualKeyCode=number, **common)
        self.settle()

    def click(self, x: float, y: float) -> None:
        """The left button at a place of the window, in CSS pixels."""
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.call(
                "Input.dispatchMouseEvent",
                type=kind, x=x, y=y, button="left", clickCount=1,
            )  # fmt: skip
        self.settle()

    def move(self, x: float, y: float) -> None:
        """The pointer to a place of the window."""
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        self.settle()

    def drag(self, x0: float, y0: float, x1: float, y1: float) -> None:
        """The left button held from one place to another."""
        steps = [("mouseMoved", x0, y0), ("mousePressed", x0, y0)]
        steps += [("mouseMoved", x0 + s * (x1 - x0), y0 + s * (y1 - y0)) for s in (0.3, 0.6, 1.0)]
        for kind, x, y in [*steps, ("mouseReleased", x1, y1)]:
            self.call(
                "Input.dispatchMouseEvent",
                type=kind, x=x, y=y, button="left", buttons=1, clickCount=1,
            )  # fmt: skip
        self.settle()

    def rect(self, selector: str) -> dict[str, float]:
        """Where an element is in the window, scrolled into it."""
        found = self.run(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
            " e.scrollIntoView({block: 'center'}); const r = e.getBoundingClientRect();"
            " return {x: r.x, y: r.y, width: r.width, height: r.height}; })()"
        )
        assert isinstance(found, dict)
        return found

    def picture(self, selector: str | None = None, *, whole: bool = False) -> bytes:
        """PNG of the window, of all of the page, or of one element."""
        options: dict[str, object] = {"format": "png", "captureBeyondViewport": whole}
        if selector:
            options["clip"] = {**self._page_rect(selector), "scale": 1}
        return base64.b64decode(self.call("Page.captureScreenshot", **options)["data"])

    def _page_rect(self, selector: str) -> dict[str, float]:
        rect = self.rect(selector)
        self.settle()
        scroll = self.run("[scrollX, scrollY]")
        assert isinstance(scroll, list)
        return {**rect, "x": rect["x"] + scroll[0], "y": rect["y"] + scroll[1]}

    def _sort_events(self) -> None:
        events = self._browser.events
        for _ in range(len(events)):
            event = events.popleft()
            if event.get("sessionId") != self._session:
                events.append(event)
                continue
            note = NOTES.get(event["method"])
            if note:
                note(self, event["params"])


def _request(page: Page, params: dict[str, Any]) -> None:
    page.requests.append(params["request"]["url"])


# What software drawing says of itself when a picture of the page is taken.
OWN_NOISE = "GL Driver Message"


def _console(page: Page, params: dict[str, Any]) -> None:
    if params["type"] in ("error", "assert", "warning"):
        said = " ".join(str(a.get("value", a.get("description"))) for a in params["args"])
        page.troubles.append(f"{params['type']}: {said}")


def _exception(page: Page, params: dict[str, Any]) -> None:
    details = params["exceptionDetails"]
    page.troubles.append(details.get("exception", {}).get("description", details["text"]))


def _entry(page: Page, params: dict[str, Any]) -> None:
    entry = params["entry"]
    if entry["level"] in ("error", "warning") and OWN_NOISE not in entry["text"]:
        page.troubles.append(f"{entry['level']}: {entry['text']}")


NOTES = {
    "Network.requestWillBeSent": _request,
    "Runtime.consoleAPICalled": _console,
    "Runtime.exceptionThrown": _exception,
    "Log.entryAdded": _entry,
}
