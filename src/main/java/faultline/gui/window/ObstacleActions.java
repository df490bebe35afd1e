package faultline.gui.window;

import static faultline.gui.action.Keystrokes.menu;
import static faultline.gui.action.Keystrokes.plain;

import faultline.geometry.Degrees;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.CanvasTools;
import faultline.gui.edit.Copies;
import faultline.gui.edit.Editor;
import faultline.gui.edit.ReadyShape;
import faultline.gui.edit.Snap;
import faultline.gui.text.Texts;
import faultline.gui.text.Wordings;
import faultline.gui.theme.Glyph;
import faultline.scenario.ObstacleText;
import faultline.scenario.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;

/** The actions on obstacles: new ones from the palette, copies by way of the clipboard, deleting, ways, and snapping. */
final class ObstacleActions {

    /** The palette: all that makes a new obstacle, in the order of its buttons. */
    static final List<String> PALETTE = List.of("placeRectangle", "placeSquare", "placeCircle", "placeEllipse", "placeTriangle", "placeHexagon",
            "placeAngle", "drawWall", "drawPolygon");

    private static final Map<ReadyShape, Glyph> GLYPHS = Map.of(ReadyShape.RECTANGLE, Glyph.RECTANGLE, ReadyShape.SQUARE, Glyph.SQUARE,
            ReadyShape.CIRCLE,
            Glyph.CIRCLE, ReadyShape.ELLIPSE, Glyph.ELLIPSE, ReadyShape.TRIANGLE, Glyph.TRIANGLE, ReadyShape.HEXAGON, Glyph.HEXAGON, ReadyShape.ANGLE,
            Glyph.ANGLE);
    private static final double GRID = 0.05;
    private static final double TURN = Degrees.toRadians(15);

    private final CanvasTools tools;
    private final Editor editor;
    private final Consumer<String> note;
    private final DoubleFunction<OptionalDouble> askSpeed;
    private final WindowMemory memory;
    private final UiAction snapGrid;
    private final UiAction snapAngle;

    /**
     * Actions that are not shown yet.
     *
     * @param tools of the canvas
     * @param editor where changes go
     * @param note told what the user should know
     * @param askSpeed asks for a speed, metres per second, given the present one
     * @param memory keeps how obstacles snap
     */
    ObstacleActions(CanvasTools tools, Editor editor, Consumer<String> note, DoubleFunction<OptionalDouble> askSpeed, WindowMemory memory) {
        this.tools = tools;
        this.editor = editor;
        this.note = note;
        this.askSpeed = askSpeed;
        this.memory = memory;
        snapGrid = UiAction.toggle("snapGrid", memory.isGridSnapped(), on -> snap());
        snapAngle = UiAction.toggle("snapAngle", memory.isAngleSnapped(), on -> snap());
        snap();
    }

    void addTo(UiActions actions) {
        for (ReadyShape shape : ReadyShape.values()) {
            String name = shape.name();
            String key = "place" + name.charAt(0) + name.substring(1).toLowerCase(Locale.ROOT);
            actions.add(tool(key, () -> tools.place(shape)).drawn(GLYPHS.get(shape)));
        }
        actions.add(tool("drawWall", tools::drawWall).drawn(Glyph.WALL));
        actions.add(tool("drawPolygon", tools::drawPolygon).drawn(Glyph.POLYGON));
        actions.add(UiAction.of("drawWay", this::drawWay));
        actions.add(UiAction.of("waySpeed", this::setSpeed));
        actions.add(UiAction.of("standStill", this::standStill));
        actions.add(UiAction.of("cut", this::cut).on(menu(KeyEvent.VK_X)));
        actions.add(UiAction.of("copy", this::copied).on(menu(KeyEvent.VK_C)));
        actions.add(UiAction.of("paste", this::paste).on(menu(KeyEvent.VK_V)));
        actions.add(UiAction.of("duplicate", () -> put(tools.selected())).on(menu(KeyEvent.VK_D)));
        actions.add(UiAction.of("delete", this::delete).on(plain(KeyEvent.VK_DELETE)));
        actions.add(UiAction.of("selectAll", tools::selectAll).on(menu(KeyEvent.VK_A)));
        actions.add(snapGrid);
        actions.add(snapAngle);
    }

    private UiAction tool(String key, Runnable tool) {
        UiAction[] self = new UiAction[1];
        self[0] = UiAction.of(key, () -> use(self[0], tool));
        tools.addToolListener(inUse -> self[0].setOn(false));
        return self[0];
    }

    /** Says how a tool is used, and shows that it is. */
    private void use(UiAction action, Runnable tool) {
        tool.run();
        action.setOn(true);
        note.accept(Texts.text("action." + action.key() + ".tip"));
    }

    private void snap() {
        tools.setSnap(new Snap(snapGrid.isOn() ? GRID : 0, snapAngle.isOn() ? TURN : 0));
        memory.keepSnap(snapGrid.isOn(), snapAngle.isOn());
    }

    private void drawWay() {
        if (tools.selected().size() == 1) {
            tools.drawWay();
            note.accept(Texts.text("action.drawWay.tip"));
        } else {
            note.accept(Texts.text("note.selectOne"));
        }
    }

    /** Of all selected obstacles that move. */
    private void setSpeed() {
        List<Obstacle> moving = tools.selected().stream().filter(obstacle -> obstacle.motion().isPresent()).toList();
        if (moving.isEmpty()) {
            note.accept(Texts.text("note.selectMoving"));
        } else {
            askSpeed.apply(moving.get(0).motion().orElseThrow().speed()).ifPresent(speed -> editor.send(moving.stream()
                    .<Command>map(obstacle -> new Command.PutObstacle(obstacle.moving(obstacle.motion().map(way -> way.at(speed))))).toList()));
        }
    }

    private void standStill() {
        editor.send(tools.selected().stream().filter(obstacle -> obstacle.motion().isPresent())
                .<Command>map(obstacle -> new Command.PutObstacle(obstacle.moving(Optional.empty()))).toList());
    }

    private void cut() {
        if (copied()) {
            delete();
        }
    }

    private void delete() {
        editor.send(tools.selected().stream().<Command>map(obstacle -> new Command.RemoveObstacle(obstacle.id())).toList());
    }

    /** Copies what is selected; says whether it is on the clipboard. */
    private boolean copied() {
        if (tools.selected().isEmpty()) {
            return false;
        }
        try {
            clipboard().setContents(new StringSelection(ObstacleText.write(tools.selected())), null);
            return true;
        } catch (IllegalStateException busy) {
            note.accept(Texts.text("note.clipboardBusy"));
            return false;
        }
    }

    private void paste() {
        try {
            pastedText().ifPresent(this::paste);
        } catch (IllegalStateException busy) {
            note.accept(Texts.text("note.clipboardBusy"));
        }
    }

    private void paste(String text) {
        try {
            put(ObstacleText.read(text));
        } catch (ScenarioException bad) {
            int more = bad.complaints().size() - 1;
            String first = Wordings.text(bad.complaints().get(0).text());
            note.accept(more == 0 ? Texts.text("note.notPasted", first) : Texts.text("note.notPasted.more", first, Integer.toString(more)));
        }
    }

    private static Optional<String> pastedText() {
        try {
            return Optional.of((String) clipboard().getData(DataFlavor.stringFlavor));
        } catch (UnsupportedFlavorException | IOException noText) {
            return Optional.empty();
        }
    }

    private static Clipboard clipboard() {
        return Toolkit.getDefaultToolkit().getSystemClipboard();
    }

    private void put(List<Obstacle> originals) {
        List<Obstacle> copies = Copies.of(originals, tools.ids());
        tools.selectSoon(copies.stream().map(Obstacle::id).toList());
        editor.send(copies.stream().<Command>map(Command.PutObstacle::new).toList());
    }
}
