package faultline.gui.canvas.tool;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SampleFrames;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ShapePreset;
import faultline.paint.scene.Layer;
import faultline.paint.surface.Camera;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;

/** Small movements during clicks, and several buttons at a time. No display is needed. */
class CanvasMouseTest {

    private final List<Command> sent = new ArrayList<>();
    private final List<Point> menus = new ArrayList<>();
    private final SimulationCanvas canvas = callOnEdt(() -> {
        SimulationCanvas made =
                new SimulationCanvas(new CommandSender((commands, onExecuted) -> sent.addAll(commands)));
        made.setSize(600, 440);
        made.setFrame(SampleFrames.frameOf(
                new Pose(1, 1, 0), new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0))));
        made.tools().listeners().addMenuListener(menus::add);
        return made;
    });

    @Test
    void aClickWithASmallMovementDeselectsAndLeavesTheViewUnchanged() {
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        Camera fitted = callOnEdt(canvas::camera);
        Vector2 ground = screen(new Vector2(2, 3));
        mouse(MouseEvent.MOUSE_PRESSED, ground, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, ground.plus(new Vector2(1, 1)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, ground.plus(new Vector2(1, 1)), MouseEvent.BUTTON1);
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
        assertEquals(fitted, callOnEdt(canvas::camera));
        runOnEdt(() -> canvas.setSize(500, 440));
        assertNotEquals(
                fitted.scale(), callOnEdt(() -> canvas.camera().scale()), "the world is still fitted into the canvas");
    }

    private void drag(Vector2 from, double pixels, int button) {
        mouse(MouseEvent.MOUSE_PRESSED, from, button);
        mouse(MouseEvent.MOUSE_DRAGGED, from.plus(new Vector2(pixels, 0)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, from.plus(new Vector2(pixels, 0)), button);
    }

    /** A question about the file may hide the release of the button, and its answer may open another scenario. */
    @Test
    void aDragAndAToolEndWithTheirScenario() {
        Vector2 box = screen(new Vector2(4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(9, 0)), MouseEvent.NOBUTTON);
        sent.clear();
        runOnEdt(canvas.tools()::startScenario);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(30, 0)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, box.plus(new Vector2(30, 0)), MouseEvent.BUTTON1);
        assertEquals(List.of(), sent);
        List<Boolean> active = new ArrayList<>();
        runOnEdt(() -> {
            canvas.tools().addToolListener(active::add);
            canvas.tools().drawPolygon();
            canvas.tools().startScenario();
        });
        assertEquals(List.of(true, false), active);
    }

    @Test
    void aPolygonWhosePointsAreOnOneLineIsRefused() {
        List<String> notes = new ArrayList<>();
        runOnEdt(() -> {
            canvas.tools().listeners().addNoteListener((note, holds) -> notes.add(note));
            canvas.tools().drawPolygon();
        });
        for (Vector2 at : List.of(new Vector2(40, 40), new Vector2(80, 80), new Vector2(60, 60))) {
            click(at);
        }
        runOnEdt(() -> press("ENTER"));
        assertEquals(List.of("All points are on one line; draw a wall instead"), notes);
        assertEquals(List.of(), sent);
        click(new Vector2(40, 60));
        runOnEdt(() -> press("ENTER"));
        assertEquals(1, sent.size(), "the tool has stayed");
    }

    private void click(Vector2 at) {
        mouse(MouseEvent.MOUSE_PRESSED, at, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_RELEASED, at, MouseEvent.BUTTON1);
    }

    @Test
    void thePointOfAToolIsShownAtThePointerOrInTheCentreOfTheView() {
        assertSketchedAt(new Vector2(300, 220));
        mouse(MouseEvent.MOUSE_MOVED, new Vector2(410, 130), MouseEvent.NOBUTTON);
        assertSketchedAt(new Vector2(410, 130));
    }

    /** Asserts that tools for points change the picture of the canvas near a point only, pixels. */
    private void assertSketchedAt(Vector2 place) {
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        BufferedImage before = picture();
        for (Consumer<CanvasTools> tool : List.<Consumer<CanvasTools>>of(
                CanvasTools::drawWall, CanvasTools::drawPolygon, CanvasTools::drawMotionPath)) {
            runOnEdt(() -> tool.accept(canvas.tools()));
            BufferedImage after = picture();
            List<Vector2> changed = IntStream.range(0, before.getWidth() * before.getHeight())
                    .mapToObj(i -> new Vector2(i % before.getWidth(), i / before.getWidth()))
                    .filter(at -> before.getRGB((int) at.x(), (int) at.y()) != after.getRGB((int) at.x(), (int) at.y()))
                    .toList();
            assertFalse(changed.isEmpty());
            assertEquals(
                    List.of(),
                    changed.stream().filter(at -> at.distanceTo(place) > 10).toList());
            runOnEdt(canvas.tools()::endTool);
        }
    }

    @Test
    void thePointThatKeysHaveSetEndsWithTheTool() {
        List<Optional<Vector2>> cursor = new ArrayList<>();
        runOnEdt(() -> {
            canvas.addCursorListener(cursor::add);
            press("INSERT");
            assertEquals(List.of(), cursor, "there is no tool");
            canvas.tools().drawWall();
            press("shift RIGHT");
        });
        Vector2 moved = lastOf(cursor).orElseThrow();
        runOnEdt(canvas.tools()::drawPolygon);
        assertEquals(moved, lastOf(cursor).orElseThrow(), "another tool takes over the point");
        runOnEdt(canvas.tools()::startScenario);
        assertEquals(Optional.empty(), lastOf(cursor));
        assertSketchedAt(new Vector2(300, 220));
    }

    @Test
    void thePointOfTheMouseIsShownAgainAfterAToolWithKeys() {
        List<Optional<Vector2>> cursor = new ArrayList<>();
        mouse(MouseEvent.MOUSE_MOVED, new Vector2(410, 130), MouseEvent.NOBUTTON);
        runOnEdt(() -> {
            canvas.addCursorListener(cursor::add);
            canvas.tools().placeShape(ShapePreset.CIRCLE);
            press("RIGHT");
            press("INSERT");
        });
        assertEquals(1, sent.size());
        Vector2 shown = screen(lastOf(cursor).orElseThrow());
        assertEquals(0, shown.distanceTo(new Vector2(410, 130)), 1e-9);
    }

    private static <T> T lastOf(List<T> values) {
        return values.get(values.size() - 1);
    }

    private BufferedImage picture() {
        BufferedImage image = new BufferedImage(600, 440, BufferedImage.TYPE_INT_RGB);
        runOnEdt(() -> canvas.paint(image.createGraphics()));
        return image;
    }

    @Test
    void aPathIsDrawnForAnObstacleWhereTheRunWillPutIt() {
        runOnEdt(() -> {
            canvas.tools().select(List.of("box"));
            press("RIGHT");
            canvas.tools().drawMotionPath();
        });
        drag(screen(new Vector2(2, 3)), 0, MouseEvent.BUTTON1);
        runOnEdt(() -> press("ENTER"));
        Pose moved = ((Command.MoveObstacle) sent.get(0)).pose();
        Obstacle placed = ((Command.PlaceObstacle) sent.get(1)).obstacle();
        assertEquals(moved, placed.pose());
        assertEquals(moved.position(), placed.motion().waypoints().get(1));
    }

    @Test
    void aPathIsDrawnForAnObstacleThatIsRenamedMeanwhile() {
        runOnEdt(() -> {
            canvas.tools().select(List.of("box"));
            canvas.tools().drawMotionPath();
            canvas.tools().renameObstacles(id -> "crate");
            canvas.setFrame(SampleFrames.frameOf(
                    new Pose(1, 1, 0),
                    new Obstacle("crate", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0))));
        });
        drag(screen(new Vector2(2, 3)), 0, MouseEvent.BUTTON1);
        runOnEdt(() -> press("ENTER"));
        assertEquals("crate", ((Command.PlaceObstacle) sent.get(0)).obstacle().id());
    }

    /** The press applies an id that was typed, and the run has it a few frames later. */
    @Test
    void anObstacleThatIsRenamedMeanwhileIsStillDragged() {
        Vector2 box = screen(new Vector2(4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(9, 0)), MouseEvent.NOBUTTON);
        runOnEdt(() -> {
            canvas.tools().renameObstacles(id -> "crate");
            canvas.setFrame(SampleFrames.frameOf(
                    new Pose(1, 1, 0),
                    new Obstacle("crate", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0))));
        });
        sent.clear();
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(60, 0)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, box.plus(new Vector2(60, 0)), MouseEvent.BUTTON1);
        assertEquals(1, sent.size());
        assertEquals("crate", ((Command.MoveObstacle) sent.get(0)).obstacle());
    }

    @Test
    void anObstacleIsResizedWhereTheRunWillPutIt() {
        runOnEdt(() -> {
            canvas.tools().select(List.of("box"));
            press("UP");
        });
        Pose nudged = ((Command.MoveObstacle) sent.get(0)).pose();
        drag(screen(new Vector2(4.4, 2)), 20, MouseEvent.BUTTON1);
        Obstacle resized = ((Command.PlaceObstacle) sent.get(1)).obstacle();
        assertEquals(nudged.y(), resized.pose().y());
    }

    /** A dialog that opens during a drag gets the release of the button. */
    @Test
    void aDragIsCompleteWhenTheMouseMovesWithoutAButton() {
        Vector2 box = screen(new Vector2(4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(9, 0)), MouseEvent.NOBUTTON);
        sent.clear();
        mouse(MouseEvent.MOUSE_MOVED, box.plus(new Vector2(30, 0)), MouseEvent.NOBUTTON);
        runOnEdt(() -> press("ESCAPE"));
        assertEquals(List.of(), sent, "the obstacle stays where it was dragged");
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
    }

    @Test
    void aShapeIsPlacedAsItWasDrawnWhenTheMouseMovesWithoutAButton() {
        Vector2 corner = screen(new Vector2(2, 3));
        runOnEdt(() -> canvas.tools().placeShape(ShapePreset.RECTANGLE));
        mouse(MouseEvent.MOUSE_PRESSED, corner, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(3, 3.5)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_MOVED, screen(new Vector2(5, 1)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(5, 1)), MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_RELEASED, screen(new Vector2(5, 1)), MouseEvent.BUTTON1);
        Obstacle placed = ((Command.PlaceObstacle) sent.get(0)).obstacle();
        assertEquals(1, sent.size());
        assertEquals(1, ((ObstacleShape.RectangleShape) placed.shape()).width(), 0.02);
        assertEquals(2.5, placed.pose().x(), 0.02);
    }

    @Test
    void panningWithTheMiddleButtonLeavesTheDrawnShapeAlone() {
        runOnEdt(() -> canvas.tools().placeShape(ShapePreset.RECTANGLE));
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(2, 3)), MouseEvent.BUTTON1);
        Vector2 corner = screen(new Vector2(3, 3.5));
        mouse(MouseEvent.MOUSE_DRAGGED, corner, MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_PRESSED, corner, MouseEvent.BUTTON2);
        mouse(MouseEvent.MOUSE_RELEASED, corner, MouseEvent.BUTTON2);
        assertEquals(List.of(), sent);
        mouse(MouseEvent.MOUSE_RELEASED, corner, MouseEvent.BUTTON1);
        assertEquals(1, sent.size());
    }

    @Test
    void aToolThatIsCancelledWhileTheButtonIsDownPlacesNothing() {
        runOnEdt(() -> canvas.tools().placeShape(ShapePreset.RECTANGLE));
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(2, 3)), MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(3, 3.5)), MouseEvent.NOBUTTON);
        runOnEdt(() -> {
            press("ESCAPE");
            canvas.tools().placeShape(ShapePreset.CIRCLE);
        });
        mouse(MouseEvent.MOUSE_MOVED, screen(new Vector2(5, 1)), MouseEvent.NOBUTTON);
        assertEquals(List.of(), sent);
    }

    @Test
    void aDragIsCompleteWhenTheButtonIsPressedAgain() {
        Vector2 box = screen(new Vector2(4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(9, 0)), MouseEvent.NOBUTTON);
        sent.clear();
        Vector2 ground = screen(new Vector2(2, 3));
        mouse(MouseEvent.MOUSE_PRESSED, ground, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, ground.plus(new Vector2(1, 0)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, ground.plus(new Vector2(1, 0)), MouseEvent.BUTTON1);
        assertEquals(List.of(), sent);
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
    }

    @Test
    void anObstacleMovesFromThreePixelsOn() {
        drag(screen(new Vector2(4, 2)), 2, MouseEvent.BUTTON1);
        assertEquals(List.of(), sent);
        drag(screen(new Vector2(4, 2)), 3, MouseEvent.BUTTON1);
        assertEquals(1, sent.size());
    }

    /** A robot that has not started cannot collide with what is being arranged. */
    @Test
    void anObstacleIsNotDraggedOntoTheRobotBeforeTheRunStarts() {
        dragBoxAcrossTheRobot();
        assertEquals(3, sent.size(), "the run has started");
        sent.clear();
        SimulationSetup setup = SimulationSetup.of(
                new WorldSpec(
                        6,
                        4,
                        true,
                        3,
                        List.of(new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0)))),
                new Pose(1, 1, 0));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            runOnEdt(() -> canvas.setFrame(simulation.frame()));
        }
        dragBoxAcrossTheRobot();
        assertEquals(2, sent.size());
    }

    @Test
    void aDragOfARobotThatHasStartedIsRefusedWithANoteAndKeepsTheView() {
        List<String> notes = new ArrayList<>();
        List<Pose> starts = new ArrayList<>();
        List<Predicate<Snapshot>> held = new ArrayList<>();
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of()), new Pose(1, 1, 0));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            Snapshot atStart = simulation.snapshot();
            simulation.tick();
            runOnEdt(() -> {
                canvas.setFrame(simulation.frame());
                canvas.tools().listeners().addStartListener(starts::add);
                canvas.tools().listeners().addNoteListener((note, holds) -> {
                    notes.add(note);
                    held.add(holds);
                });
            });
            Camera fitted = callOnEdt(canvas::camera);
            drag(screen(new Vector2(1, 1)), 2, MouseEvent.BUTTON1);
            assertEquals(List.of(), notes);
            drag(screen(new Vector2(1, 1)), 90, MouseEvent.BUTTON1);
            assertEquals(List.of("The robot can be moved at 0 s only; choose Simulation > Restart first"), notes);
            assertTrue(held.get(0).test(simulation.snapshot()));
            assertFalse(held.get(0).test(atStart), "the note ends with a restart");
            assertEquals(List.of(), starts);
            assertEquals(fitted, callOnEdt(canvas::camera));
            drag(screen(new Vector2(3, 3)), 90, MouseEvent.BUTTON1);
            assertNotEquals(fitted, callOnEdt(canvas::camera));
        }
    }

    private void dragBoxAcrossTheRobot() {
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(4, 2)), MouseEvent.BUTTON1);
        for (Vector2 to : List.of(new Vector2(2, 2), new Vector2(1, 1), new Vector2(1, 2.5))) {
            mouse(MouseEvent.MOUSE_DRAGGED, screen(to), MouseEvent.NOBUTTON);
        }
        mouse(MouseEvent.MOUSE_RELEASED, screen(new Vector2(1, 2.5)), MouseEvent.BUTTON1);
    }

    @Test
    void theGroundClicksBelowThreePixelsAndPansFromThereOn() {
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        drag(screen(new Vector2(2, 3)), 3, MouseEvent.BUTTON1);
        assertEquals(1, callOnEdt(canvas.tools()::selected).size(), "no click");
        drag(screen(new Vector2(2, 3)), 2, MouseEvent.BUTTON1);
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
    }

    @Test
    void theWheelWithShiftPans() {
        Vector2 before = screen(new Vector2(2, 3));
        runOnEdt(() -> canvas.dispatchEvent(new MouseWheelEvent(
                canvas,
                MouseEvent.MOUSE_WHEEL,
                0,
                InputEvent.SHIFT_DOWN_MASK,
                10,
                10,
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                3,
                1)));
        Vector2 moved = screen(new Vector2(2, 3)).minus(before);
        assertEquals(-60, moved.x(), 1e-9);
        assertEquals(0, moved.y(), 1e-9);
    }

    @Test
    void theKeyOpensTheMenuOfWhatIsSelected() {
        runOnEdt(() -> {
            canvas.tools().select(List.of("box"));
            press("shift F10");
        });
        assertEquals(MenuTarget.OBSTACLE, callOnEdt(() -> canvas.tools().targetAt(menus.get(0))));
        runOnEdt(() -> {
            canvas.tools().select(List.of());
            canvas.setFrame(SampleFrames.fullFrame());
            canvas.tools().selectSensor("front-left");
            press("shift F10");
        });
        assertEquals("front-left", callOnEdt(() -> canvas.tools()
                .selectSensorAt(menus.get(1))
                .orElseThrow()
                .spec()
                .id()));
        runOnEdt(() -> {
            canvas.tools().clearSelection();
            press("shift F10");
        });
        assertEquals(new Point(0, 0), menus.get(2), "where the mouse was pressed last");
    }

    private void press(String keys) {
        KeyStroke key = KeyStroke.getKeyStroke(keys);
        canvas.getActionForKeyStroke(key).actionPerformed(new ActionEvent(canvas, ActionEvent.ACTION_PERFORMED, ""));
    }

    @Test
    void aWaypointOfTheSelectedObstacleIsDragged() {
        WaypointPath motion = new WaypointPath(0.2, true, List.of(new Vector2(2, 3), new Vector2(5, 3)));
        Obstacle still =
                new Obstacle("visitor", new ObstacleShape.CircleShape(0.2), new Pose(4, 2, 0)).withMotion(motion);
        Obstacle moved = still.withPose(new Pose(3.5, 2.5, 0));
        Vector2 waypoint = screen(new Vector2(5, 3));
        runOnEdt(() -> {
            canvas.setFrame(SampleFrames.frameOf(new Pose(1, 1, 0), still));
            canvas.tools().select(List.of("visitor"));
        });
        mouse(MouseEvent.MOUSE_PRESSED, waypoint, MouseEvent.BUTTON1);
        runOnEdt(() -> canvas.setFrame(SampleFrames.frameOf(new Pose(1, 1, 0), moved)));
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(5, 1)), MouseEvent.NOBUTTON);
        Command last = sent.get(sent.size() - 1);
        Obstacle placed = ((Command.PlaceObstacle) last).obstacle();
        assertEquals(moved.pose(), placed.pose(), "the obstacle continues from where it is");
        assertEquals(motion.waypoints().get(0), placed.motion().waypoints().get(0));
        assertEquals(0, placed.motion().waypoints().get(1).distanceTo(new Vector2(5, 1)), 0.02);
        mouse(MouseEvent.MOUSE_RELEASED, screen(new Vector2(5, 1)), MouseEvent.BUTTON1);
        runOnEdt(() -> canvas.tools().select(List.of()));
        sent.clear();
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(2, 3)), MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(2, 2.5)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_RELEASED, screen(new Vector2(2, 2.5)), MouseEvent.BUTTON1);
        assertEquals(List.of(), sent, "an obstacle that is not selected has no handles");
        runOnEdt(() -> {
            canvas.setFrame(SampleFrames.frameOf(new Pose(1, 1, 0), still.withPose(new Pose(5, 3, 0))));
            canvas.tools().select(List.of("visitor"));
        });
        mouse(MouseEvent.MOUSE_PRESSED, waypoint, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(5, 1)), MouseEvent.NOBUTTON);
        assertTrue(sent.get(0) instanceof Command.MoveObstacle, "the obstacle covers its waypoint");
    }

    @Test
    void aDragOfAWaypointKeepsWhereTheRunWillPutTheObstacle() {
        WaypointPath motion = new WaypointPath(0.2, true, List.of(new Vector2(2, 3), new Vector2(5, 3)));
        Obstacle visitor =
                new Obstacle("visitor", new ObstacleShape.CircleShape(0.2), new Pose(4, 2, 0)).withMotion(motion);
        runOnEdt(() -> {
            canvas.setFrame(SampleFrames.frameOf(new Pose(1, 1, 0), visitor));
            canvas.tools().select(List.of("visitor"));
            press("RIGHT");
        });
        mouse(MouseEvent.MOUSE_PRESSED, screen(new Vector2(5, 3)), MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, screen(new Vector2(5, 1)), MouseEvent.NOBUTTON);
        assertEquals(
                4.01, ((Command.PlaceObstacle) sent.get(1)).obstacle().pose().x());
    }

    /** The next movement of the mouse would put the obstacle back. */
    @Test
    void keysDoNotMoveWhatIsDragged() {
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        Vector2 side = screen(new Vector2(4.4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, side, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, side.plus(new Vector2(20, 0)), MouseEvent.NOBUTTON);
        assertEquals(1, sent.size());
        Camera view = callOnEdt(canvas::camera);
        runOnEdt(() -> List.of("RIGHT", "shift UP", "Q", "E").forEach(this::press));
        assertEquals(1, sent.size());
        assertEquals(view, callOnEdt(canvas::camera));
        mouse(MouseEvent.MOUSE_RELEASED, side.plus(new Vector2(20, 0)), MouseEvent.BUTTON1);
        runOnEdt(() -> List.of("RIGHT", "shift UP", "Q", "E").forEach(this::press));
        assertEquals(5, sent.size());
    }

    @Test
    void whatIsUnderTheCursorDecidesAboutTheMenu() {
        MenuTarget[] targets = callOnEdt(() ->
                new MenuTarget[] {target(new Vector2(4, 2)), target(new Vector2(1, 1)), target(new Vector2(5.5, 3.5))});
        assertArrayEquals(new MenuTarget[] {MenuTarget.OBSTACLE, MenuTarget.ROBOT, MenuTarget.FLOOR}, targets);
    }

    @Test
    void theMenuOfTheRobotIsThatOfItsWholePlatformOnly() {
        RobotSpec robot =
                callOnEdt(() -> canvas.frame().orElseThrow().snapshot().robot());
        double ahead = robot.length() / 2;
        double aside = robot.width() / 2;
        assertEquals(MenuTarget.ROBOT, callOnEdt(() -> target(new Vector2(1 + ahead - 0.02, 1 + aside - 0.02))));
        assertEquals(MenuTarget.FLOOR, callOnEdt(() -> target(new Vector2(1 + ahead + 0.02, 1))));
        assertEquals(MenuTarget.FLOOR, callOnEdt(() -> target(new Vector2(1, 1 + aside + 0.02))));
    }

    @Test
    void aClickOnAWaypointSelectsItsObstacle() {
        Obstacle visitor = new Obstacle("visitor", new ObstacleShape.CircleShape(0.2), new Pose(4, 2, 0))
                .withMotion(new WaypointPath(0.2, true, List.of(new Vector2(2, 3), new Vector2(5, 3))));
        runOnEdt(() -> canvas.setFrame(SampleFrames.frameOf(new Pose(1, 1, 0), visitor)));
        for (int button : new int[] {MouseEvent.BUTTON1, MouseEvent.BUTTON3}) {
            click(screen(new Vector2(5, 3)), button);
            assertEquals(List.of("visitor"), selectedIds());
            assertEquals(MenuTarget.OBSTACLE, callOnEdt(() -> target(new Vector2(5, 3))));
            click(screen(new Vector2(3, 3.5)), MouseEvent.BUTTON1);
            assertEquals(List.of(), selectedIds());
        }
        runOnEdt(() -> canvas.setLayer(Layer.ROUTES, false));
        click(screen(new Vector2(5, 3)), MouseEvent.BUTTON1);
        assertEquals(List.of(), selectedIds(), "the waypoint is not shown");
        assertEquals(MenuTarget.FLOOR, callOnEdt(() -> target(new Vector2(5, 3))));
    }

    private void click(Vector2 at, int button) {
        mouse(MouseEvent.MOUSE_PRESSED, at, button);
        mouse(MouseEvent.MOUSE_RELEASED, at, button);
    }

    private List<String> selectedIds() {
        return callOnEdt(
                () -> canvas.tools().selected().stream().map(Obstacle::id).toList());
    }

    private MenuTarget target(Vector2 world) {
        Vector2 at = canvas.camera().toScreen(world);
        return canvas.tools().targetAt(new Point((int) at.x(), (int) at.y()));
    }

    @Test
    void aPanGoesAsFarAsTheMouse() {
        Vector2 ground = screen(new Vector2(2, 3));
        mouse(MouseEvent.MOUSE_PRESSED, ground, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, ground.plus(new Vector2(1, 0)), MouseEvent.NOBUTTON);
        mouse(MouseEvent.MOUSE_DRAGGED, ground.plus(new Vector2(30, 10)), MouseEvent.NOBUTTON);
        assertEquals(0, screen(new Vector2(2, 3)).distanceTo(ground.plus(new Vector2(30, 10))), 1e-9);
    }

    @Test
    void anotherButtonDoesNotEndADrag() {
        Vector2 box = screen(new Vector2(4, 2));
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_PRESSED, box, MouseEvent.BUTTON3);
        mouse(MouseEvent.MOUSE_RELEASED, box, MouseEvent.BUTTON3);
        assertEquals(List.of(), menus);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(20, 0)), MouseEvent.NOBUTTON);
        assertEquals(1, callOnEdt(sent::size), "the drag continues");
        mouse(MouseEvent.MOUSE_RELEASED, box.plus(new Vector2(20, 0)), MouseEvent.BUTTON1);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(40, 0)), MouseEvent.NOBUTTON);
        assertEquals(1, callOnEdt(sent::size), "and is over");
    }

    private Vector2 screen(Vector2 world) {
        return callOnEdt(() -> canvas.camera().toScreen(world));
    }

    private void mouse(int type, Vector2 at, int button) {
        int held = type == MouseEvent.MOUSE_DRAGGED ? InputEvent.BUTTON1_DOWN_MASK : 0;
        runOnEdt(() -> canvas.dispatchEvent(new MouseEvent(
                canvas, type, 0, held, (int) Math.rint(at.x()), (int) Math.rint(at.y()), 1, false, button)));
    }
}
