/** The page: connects the link, the stick, the picture and the buttons. */

import { drawSheet } from "./aircraft_sheet.js";
import { Cockpit } from "./cockpit.js";
import { ControlChooser } from "./control_chooser.js";
import { byId } from "./dom.js";
import { InstrumentPanel } from "./instrument_panel.js";
import { Levels } from "./levels.js";
import { listenToKeys } from "./keys.js";
import { FLAG, Link } from "./link.js";
import { ModesPanel } from "./modes.js";
import { RecordingsPanel, ReplayBar } from "./recordings.js";
import { SignalChooser } from "./signal_chooser.js";
import { StickInput } from "./stick.js";
import { StickIndicator } from "./stick_indicator.js";
import { StripChart } from "./strip_chart.js";
import { Tabs } from "./tabs.js";
import { Theme } from "./theme.js";
import { TopBar, sayState } from "./top_bar.js";
import { beginsByItself } from "./tour_memory.js";
import { clamp } from "./units.js";
import { ViewBar } from "./view_bar.js";

const TOUR_AFTER = 600; // ms: the first picture comes first
const PLANT_SAYS = {
  linear: "Linear: small perturbations about trim.",
  nonlinear: "Nonlinear: six degrees of freedom; a stall that no source gives is assumed. Modes and Levels are of the linearized aircraft.",
};
const query = new URLSearchParams(location.search);
let tourIsDue = beginsByItself(query.get("tour")) && !location.hash.startsWith("#experiment="); // a link to an experiment is no first visit
const theme = new Theme(query.get("theme"));
const link = new Link(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws/${sessionName()}`);
const stick = new StickInput();
const chart = new StripChart(byId("chart"), byId("past"));
const panel = await InstrumentPanel.load(byId("instruments"), query.get("instruments")?.split(",").filter(Boolean));

const cockpit = new Cockpit(
  {
    link,
    stick,
    chart,
    panel,
    theme,
    worldCanvas: byId("world"),
    hudCanvas: byId("hud"),
    figures: byId("outside-figures"),
    instrumentCanvas: byId("instruments"),
    chartCanvas: byId("chart"),
  },
  { worldKind: query.get("world") ?? "auto", look: query.get("look") },
);
const topBar = new TopBar(link, cockpit, stick);
const views = new ViewBar(byId("views"), cockpit, (words) => topBar.complain(words));
new ControlChooser(byId("control"), stick, (sentence) => topBar.say(sentence));
const indicator = new StickIndicator(byId("stick"));
const modes = new ModesPanel(byId("s-plane"), byId("modes-table"), byId("static-figures"));
const recordings = new RecordingsPanel(byId("panel-recordings"), command);
const replayBar = new ReplayBar(byId("replay"), command, () => setTimeout(sayWhereItStands, 300));
let picker = null; // fetched when it is opened
const chooser = new SignalChooser(byId("chooser"), chart);
let [inputs, laboratory] = [null, null]; // what few open on their first visit is fetched when it is opened
const tabs = new Tabs(byId("tabs"), (tab) => {
  if (tab === "recordings") recordings.refresh();
  if (tab === "aircraft" && link.latest.has("aircraft")) drawSheet(byId("panel-aircraft"), link.latest.get("aircraft"));
  if (tab === "inputs") inputs ??= openInputs();
  if (tab === "stability") laboratory ??= openLaboratory();
  if (tab === "control") openFlightControl();
});

async function openInputs() {
  const { InputsPanel } = await import("./inputs.js");
  return new InputsPanel(byId("panel-inputs"), command, link);
}

async function openLaboratory() {
  const { VariableStability } = await import("./variable_stability.js");
  return new VariableStability(byId("panel-stability"), link);
}

let whatIf = null;
recordings.onWhatIf = async (name, label) => {
  try {
    const { WhatIf } = await import("./what_if.js");
    const replay = (recording) => command("replay", { recording });
    whatIf ??= new WhatIf({ link, cockpit, replay, showView: (view) => views.show(view), done: () => recordings.refresh() });
    await whatIf.open(name, label);
  } catch (error) {
    topBar.complain(`The recording cannot be flown again. ${error.message}`);
  }
};
let flightControl = null;

/** The Flight control tab; fetched when it is opened, or when its key is pressed. */
function openFlightControl() {
  flightControl ??= import("./flight_control.js").then(({ FlightControl }) => new FlightControl(byId("panel-control"), link));
  return flightControl;
}

/** The session of this window, kept over a reload. */
function sessionName() {
  const asked = query.get("session");
  if (asked) return encodeURIComponent(asked);
  const key = "fdes.session";
  let name = null;
  try {
    name = sessionStorage.getItem(key);
    name ??= randomName();
    sessionStorage.setItem(key, name);
  } catch {
    name ??= randomName(); // storage may be forbidden: a reload then begins another flight
  }
  return name;
}

// crypto.randomUUID exists only on secure pages, and a class may well use plain http.
function randomName() {
  return [...crypto.getRandomValues(new Uint8Array(4))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

async function chooseAircraft() {
  try {
    const { AircraftPicker } = await import("./aircraft_picker.js");
    picker ??= new AircraftPicker(byId("picker"), fly);
    picker.setCurrent(cockpit.aircraft);
    picker.open();
  } catch (error) {
    topBar.complain(`The hangar could not be opened. ${error.message}`);
  }
}

let newAircraft = null; // fetched when it is opened

/** The form for a new aircraft. */
async function openNewAircraft() {
  try {
    const { NewAircraft } = await import("./new_aircraft.js");
    newAircraft ??= await NewAircraft.made(flyFile, async () => (await link.command("save_aircraft")).text);
    newAircraft.open();
  } catch (error) {
    topBar.complain(`The form for a new aircraft could not be opened. ${error.message}`);
  }
}
document.addEventListener("new-aircraft", openNewAircraft);

let gamepadDialog = null; // fetched when it is opened

/** The set-up of the gamepad. */
async function setUpGamepad() {
  try {
    const { GamepadDialog } = await import("./gamepad_dialog.js");
    gamepadDialog ??= new GamepadDialog(stick);
    gamepadDialog.open();
  } catch (error) {
    topBar.complain(`The set-up of the gamepad could not be opened. ${error.message}`);
  }
}
document.addEventListener("set-up-gamepad", setUpGamepad);

/** Sends a command; a refusal is shown to the user. Resolves to whether it was done. */
const sayWhereItStands = () => link.has(FLAG.frozen) && !link.has(FLAG.ended) && topBar.say("Back in the flight, frozen where it was. F flies on.");

async function command(name, fields) {
  try {
    await link.command(name, fields);
    return true;
  } catch (error) {
    topBar.complain(error.message);
    return false;
  }
}

/** Another aircraft. The stick rests until the aircraft message: the old throttle would already fly it. */
function fly(aircraft, condition, variant) {
  return another(() => link.command("aircraft", { aircraft, condition, variant }));
}

/** The aircraft of a file, likewise. */
function flyFile(text) {
  return another(() => link.openText(0, text));
}

async function another(ask) {
  cockpit.flying = false;
  flown = null;
  try {
    await ask();
  } catch (error) {
    cockpit.flying = pilot;
    throw error;
  }
}

/** Back to trim. The stick goes first: what it did before must not disturb the new flight. */
async function reset() {
  stick.toTrim();
  if (pilot) link.sendStick(stick.stick, performance.now());
  await command("reset");
}

/** The same flight with the other plant. */
async function flyPlant(plant) {
  if (await command("plant", { plant })) topBar.say(PLANT_SAYS[plant]);
}

const actions = {
  freeze: () => command("freeze", { value: !link.has(FLAG.frozen) }),
  reset,
  step: () => command("step"),
  record: () => command("record", { value: !link.has(FLAG.recording) }),
  view: () => views.next(),
  instruments: () => views.chooseInstruments(),
  hud: () => topBar.say(`Head-up display: ${cockpit.hud.nextMode()}`),
  theme: () => theme.toggle(),
  plant: () => flyPlant(cockpit.aircraft.plant === "linear" ? "nonlinear" : "linear"),
  law: async () => topBar.say(await (await openFlightControl()).toggle()),
  help: async () => (await import("./help.js")).openHelp(byId("help")),
};
listenToKeys(actions);
stick.onAction = (action) => Object.hasOwn(actions, action) && actions[action]();
for (const button of document.querySelectorAll("[data-action]"))
  button.addEventListener("click", () => actions[button.dataset.action]());
byId("choose-aircraft").addEventListener("click", chooseAircraft);
byId("choose-signals").addEventListener("click", () => chooser.open());
byId("start-again").addEventListener("click", reset);
for (const dialog of document.querySelectorAll("dialog")) {
  dialog.querySelector("[data-close]").addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close()); // a click beside it
}

/** An experiment in the address is flown once, when the seat of the pilot has been taken. */
async function openShared() {
  const shared = location.hash.match(/^#experiment=(.*)$/)?.[1];
  if (shared === undefined || !pilot) return;
  history.replaceState(null, "", location.pathname + location.search);
  const { textOf } = await import("./experiment_files.js");
  try {
    await link.openText(1, textOf(shared));
    topBar.say("The experiment of the link flies.");
  } catch (error) {
    topBar.complain(error.message);
  }
}

let tour = null; // fetched for a first visit, or from help

async function takeTour() {
  tourIsDue = false;
  if (!cockpit.flying || link.has(FLAG.replay)) return topBar.say("The tour is flown: it begins where you fly yourself.");
  try {
    const { Tour } = await import("./tour.js");
    tour?.end();
    tour = new Tour({ link, cockpit, stick, view: document.querySelector(".view"), say: (words) => topBar.say(words) });
  } catch (error) {
    topBar.complain(`The tour could not be fetched. ${error.message}`);
  }
}
document.addEventListener("take-tour", takeTour);

let flown = null; // aircraft and condition, to know whether a message brings another one
let flownPlant = null;
let trimLever = 0; // which holds undisturbed flight: it is not quite the same with the other plant
let pilot = false;
let seated = false; // whether the throttle lever has been put where the simulation has it
link.on("hello", (hello) => {
  pilot = hello.role === "pilot";
  seated = false;
  cockpit.flying = false;
  byId("observer").hidden = pilot;
  chart.setChannels(hello.channels);
  topBar.showHello(hello);
  openShared();
});
link.on("frame", ({ values, index }) => {
  if (seated || flown === null) return;
  seated = true;
  stick.stick.throttle = values[index.stick_throttle];
  cockpit.flying = pilot;
  if (tourIsDue && pilot && !link.has(FLAG.replay)) setTimeout(takeTour, TOUR_AFTER);
});
link.on("aircraft", (aircraft) => {
  const now = [aircraft.id, aircraft.condition, aircraft.variant, aircraft.form, aircraft.integrator, aircraft.dt].join(" ");
  if (now !== flown) {
    flown = now;
    stick.toTrim(aircraft.trim_throttle);
    chart.clear();
    cockpit.expectTrim();
    cockpit.flying = pilot && seated;
  } else if (aircraft.plant !== flownPlant) {
    const lever = clamp(stick.stick.throttle + aircraft.trim_throttle - trimLever, 0, 1);
    Object.assign(stick, { trimThrottle: aircraft.trim_throttle, stick: { ...stick.stick, throttle: lever } });
  }
  [flownPlant, trimLever] = [aircraft.plant, aircraft.trim_throttle];
  indicator.setTrim(aircraft.trim_throttle);
  topBar.showAircraft(aircraft);
  picker?.setCurrent(aircraft);
  modes.showStatic(aircraft.static, aircraft.plant);
  if (tabs.shown === "aircraft") drawSheet(byId("panel-aircraft"), aircraft);
});
link.on("modes", (message) => modes.show(message.modes, message.bare));
link.on("knobs", () => modes.clearTrail()); // another aircraft
new Levels(byId("levels"), link);
let recorded = null;
link.on("status", (status) => {
  topBar.showStatus(status);
  replayBar.show(status.replay);
  recordings.playing = status.replay?.name ?? null;
  recordings.growing = status.recording?.name ?? null;
  const now = `${recordings.growing} ${recordings.playing}`;
  if (recorded !== null && now !== recorded && tabs.shown === "recordings") recordings.refresh();
  recorded = now;
});
link.on("error", ({ error }) => topBar.complain(error));
link.on("connection", (open) => topBar.showConnection(open));

stick.onFirstInput = () => byId("first-keys").classList.add("is-done");
theme.onChange = () => modes.drawPlane();
document.addEventListener("visibilitychange", () => {
  if (!document.hidden) return;
  stick.release(); // a hidden page draws nothing and would leave the last deflection standing
  if (cockpit.flying) link.sendStick({ ...stick.stick, pitch: 0, roll: 0, yaw: 0 }, performance.now());
});

cockpit.onFrame = (drawn) => {
  const mine = cockpit.flying && !link.has(FLAG.replay);
  indicator.draw(
    mine
      ? cockpit.held
      : { pitch: drawn.stick_pitch, roll: drawn.stick_roll, yaw: drawn.stick_yaw, throttle: drawn.stick_throttle },
  );
  topBar.showFlags();
};
cockpit.start();
setInterval(() => topBar.showPace(), 1000);
setInterval(() => link.frames && (byId("spoken").textContent = sayState(cockpit.drawn)), 4000);

/** For tests and for the curious. */
window.fdes = {
  link,
  cockpit,
  stick,
  chart,
  panel,
  theme,
  drawn: cockpit.drawn,
  stats: cockpit.stats,
  hud: cockpit.hud,
  get world() {
    return cockpit.world;
  },
};
