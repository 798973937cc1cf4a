"""A fire in a notebook: Fire(preset="candle"); fire.values = {"fuel_power": 200}; fire.stats."""

import pathlib

import anywidget
import traitlets

FOLDER = pathlib.Path(__file__).parent
ENGINE = FOLDER / "node_modules/hearth-fire/hearth-fire.inline.js"


class Fire(anywidget.AnyWidget):
    _esm = ENGINE.read_text("utf-8") + (FOLDER / "widget.js").read_text("utf-8")
    preset = traitlets.Unicode("campfire").tag(sync=True)
    values = traitlets.Dict().tag(sync=True)
    height = traitlets.Int(360).tag(sync=True)
    stats = traitlets.Dict().tag(sync=True)
