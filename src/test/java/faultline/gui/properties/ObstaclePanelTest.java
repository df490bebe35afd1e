package faultline.gui.properties;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.FieldExtremes;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.Theme;
import faultline.io.DecimalText;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.awt.event.ActionEvent;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JList;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** The list of obstacles and the attributes of the selected one, without a display. */
@ExtendWith(EdtChecker.class)
class ObstaclePanelTest {

    private static final Obstacle CRATE =
            new Obstacle("crate", new ObstacleShape.RectangleShape(0.6, 0.4), new Pose(1.3, 2.9, 0));
    private static final Obstacle VASE =
            new Obstacle("vase", new ObstacleShape.CircleShape(0.15), new Pose(4.1, 1.2, 0));
    private static final Obstacle FENCE = new Obstacle(
            "fence",
            new ObstacleShape.WallShape(List.of(new Vector2(0, 0), new Vector2(1, 0), new Vector2(1, 0.7))),
            new Pose(2.2, 0.4, 0));
    private static final Obstacle CAT = new Obstacle(
            "cat",
            new ObstacleShape.EllipseShape(0.2, 0.1),
            new Pose(5, 3, 0),
            new WaypointPath(0.4, true, List.of(new Vector2(5, 2), new Vector2(3, 3))));

    private final List<Command> commands = new ArrayList<>();
    private CommandSender sender;
    private SimulationCanvas canvas;
    private ObstaclePanel panel;

    @BeforeEach
    void show() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            sender = new CommandSender((sent, onExecuted) -> commands.addAll(sent));
            canvas = new SimulationCanvas(sender);
            Workspace workspace = new Workspace();
            ScenarioEditor scenario =
                    new ScenarioEditor(new RunController(workspace), new UndoController(sender, () -> {}));
            panel = new ObstaclePanel(sender, new ObstacleEditor(workspace, scenario), canvas.tools());
            update();
        });
    }

    private void update() {
        show(SampleFrames.frameOf(new Pose(3, 2, 0), CRATE, VASE, FENCE, CAT));
    }

    private void show(Frame frame) {
        canvas.setFrame(frame);
        for (int i = 0; i < 6; i++) {
            panel.setObstacles(frame.snapshot().obstacles());
        }
    }

    private JList<?> list() {
        return ComponentFinder.find(panel, JList.class, "Obstacles");
    }

    private void select(String... ids) {
        runOnEdt(() -> {
            canvas.tools().select(List.of(ids));
            update();
        });
    }

    private void type(String name, double value) {
        runOnEdt(() -> ComponentFinder.find(panel, JSpinner.class, name).setValue(value));
    }

    private void write(String name, String text) {
        runOnEdt(() -> {
            JTextField field = ComponentFinder.find(panel, JTextField.class, name);
            field.setText(text);
            field.postActionEvent();
        });
    }

    @Test
    void everyNumberThatAFieldAllowsCanBeSaved() {
        List<Obstacle> all = List.of(CRATE, VASE, FENCE, CAT);
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(6, 4, true, 3, all), new Pose(3, 2, 0));
        for (Obstacle obstacle : all) {
            select(obstacle.id());
            FieldExtremes.enterAll(panel, () -> FieldExtremes.save(setup, commands));
        }
    }

    /** The pillars of a plan look like obstacles of their own. */
    @Test
    void itSaysThatAPlanIsOneObstacle() {
        List<Vector2> triangle = List.of(new Vector2(0, 0), new Vector2(1, 0), new Vector2(0, 1));
        Obstacle plan = new Obstacle("plan", new ObstacleShape.PlanShape(List.of(triangle)), new Pose(0, 0, 0));
        String note = "An imported plan is one obstacle: it is moved, rotated and deleted as a whole.";
        runOnEdt(() -> show(SampleFrames.frameOf(new Pose(3, 2, 0), plan, CRATE)));
        for (Obstacle selected : List.of(plan, CRATE)) {
            runOnEdt(() -> {
                canvas.tools().select(List.of(selected.id()));
                show(SampleFrames.frameOf(new Pose(3, 2, 0), plan, CRATE));
            });
            assertEquals(selected == plan, callOnEdt(() -> ComponentFinder.findAll(panel, JTextArea.class)
                    .anyMatch(text -> text.isVisible() && text.getText().equals(note))));
        }
    }

    @Test
    void theListAndTheCanvasSelectEachOther() {
        select("vase", "cat");
        assertEquals(List.of("vase", "cat"), callOnEdt(() -> List.copyOf(list().getSelectedValuesList())));
        runOnEdt(() -> list().setSelectedIndex(2));
        assertEquals(List.of(FENCE), callOnEdt(() -> canvas.tools().selected()));
    }

    @Test
    void keysExtendTheSelectionByMoreThanOneRow() {
        runOnEdt(() -> {
            list().setSelectedIndex(0);
            update();
            for (int i = 0; i < 2; i++) {
                list().getActionMap()
                        .get("selectNextRowExtendSelection")
                        .actionPerformed(new ActionEvent(list(), 0, ""));
                update();
            }
        });
        assertEquals(List.of(CRATE, VASE, FENCE), callOnEdt(() -> canvas.tools().selected()));
    }

    @Test
    void everyAttributeIsACommand() {
        select("crate");
        type("x, m", 1.45);
        type("Heading, °", 30.0);
        type("Height, m", 0.55);
        runOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").doClick(0));
        write("Waypoints, m", "1,1 2.5,1");
        assertEquals(new Command.MoveObstacle("crate", new Pose(1.45, 2.9, 0)), commands.get(0));
        assertEquals(
                30,
                StrictMath.toDegrees(
                        ((Command.MoveObstacle) commands.get(1)).pose().heading()),
                1e-9);
        assertEquals(new ObstacleShape.RectangleShape(0.6, 0.55), placed(2).shape());
        assertTrue(placed(3).isSpecular());
        assertEquals(
                List.of(new Vector2(1, 1), new Vector2(2.5, 1)),
                placed(4).motion().waypoints());
        assertEquals(5, commands.size());
    }

    /** The selection can change before the field has lost the focus. */
    @Test
    void whatIsTypedIsForTheObstacleThatWasSelectedThen() {
        Map<String, String> typed = new LinkedHashMap<>();
        typed.put("x, m", "2.50");
        typed.put("Waypoints, m", "1,1");
        typed.put("Width, m", "2.50");
        typed.forEach((name, text) -> {
            select("crate");
            runOnEdt(() -> ComponentFinder.find(panel, JTextField.class, name).setText(text));
            select("vase");
        });
        assertEquals(new Command.MoveObstacle("crate", new Pose(2.5, 2.9, 0)), commands.get(0));
        assertEquals(List.of(new Vector2(1, 1)), placed(1).motion().waypoints());
        assertEquals(new ObstacleShape.RectangleShape(2.5, 0.4), placed(2).shape());
        assertEquals(3, commands.size());
        assertEquals("4.10", text("x, m"));
    }

    @Test
    void aTextThatIsNotAllowedIsNotKeptForTheNextObstacle() {
        select("cat");
        runOnEdt(() -> {
            ComponentFinder.find(panel, JTextField.class, "x, m").setText("2m");
            ComponentFinder.find(panel, JTextField.class, "Waypoints, m").setText("5,2 3");
        });
        select("crate");
        assertEquals(List.of("1.30", ""), List.of(text("x, m"), text("Waypoints, m")));
        assertEquals(List.of(), commands);
    }

    /** A command that replaces an obstacle would bring it back. */
    @Test
    void whatIsTypedForAnObstacleThatIsRemovedIsDropped() {
        select("crate");
        runOnEdt(() -> {
            ComponentFinder.find(panel, JTextField.class, "Width, m").setText("2.50");
            show(SampleFrames.frameOf(new Pose(3, 2, 0), VASE));
        });
        assertEquals(List.of(), commands);
        assertEquals("", text("Width, m"));
    }

    @Test
    void anObstacleWithoutWaypointsStandsStill() {
        select("cat");
        write("Waypoints, m", " ");
        assertEquals(1, commands.size());
        assertEquals(WaypointPath.NONE, placed(0).motion());
    }

    @Test
    void aChangeKeepsThoseThatHaveNotBeenAnsweredYet() {
        select("crate");
        type("Height, m", 0.55);
        runOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").doClick(0));
        assertEquals(new ObstacleShape.RectangleShape(0.6, 0.55), placed(1).shape());
        type("Height, m", 0.4);
        runOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").doClick(0));
        assertEquals(CRATE, placed(3), "sent although the last frame shows the same");
    }

    @Test
    void theFormShowsWhatTheRunHasNotAnsweredYet() {
        select("crate");
        type("Width, m", 2);
        runOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").doClick(0));
        runOnEdt(this::update);
        assertEquals(List.of("2.00", "20"), List.of(text("Width, m"), text("Gloss angle, °")));
        type("Height, m", 0.7);
        assertEquals(new ObstacleShape.RectangleShape(2, 0.7), placed(2).shape());
        assertTrue(placed(2).isSpecular());
    }

    @Test
    void waypointsThatTheRunHasNotAnsweredYetHaveASpeed() {
        select("crate");
        write("Waypoints, m", "1,1 2.5,1");
        runOnEdt(this::update);
        assertEquals(List.of("1,1 2.5,1", "0.20"), List.of(text("Waypoints, m"), text("Speed, m/s")));
        type("Speed, m/s", 0.3);
        assertEquals(
                List.of(new Vector2(1, 1), new Vector2(2.5, 1)),
                placed(1).motion().waypoints());
    }

    private Obstacle placed(int index) {
        return ((Command.PlaceObstacle) commands.get(index)).obstacle();
    }

    @Test
    void onlyWhatAppliesIsEnabled() {
        select("vase");
        assertTrue(isEnabled("Radius, m"));
        assertFalse(callOnEdt(
                () -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").isEnabled()));
        assertFalse(isEnabled("Speed, m/s"));
        select("cat");
        assertTrue(isEnabled("Radius x, m"));
        assertTrue(isEnabled("Speed, m/s"));
        select("vase", "cat");
        assertFalse(isEnabled("x, m"));
    }

    private boolean isEnabled(String name) {
        return callOnEdt(() -> ComponentFinder.find(panel, JSpinner.class, name).isEnabled());
    }

    @Test
    void pointsThatAreNotAllowedStayUntilTheFocusLeaves() {
        select("fence");
        JTextField field = callOnEdt(() -> ComponentFinder.find(panel, JTextField.class, "Points, m"));
        write("Points, m", "0,0 1,nought");
        assertEquals("0,0 1,nought", callOnEdt(field::getText));
        runOnEdt(() -> {
            for (FocusListener listener : field.getFocusListeners()) {
                listener.focusLost(new FocusEvent(field, FocusEvent.FOCUS_LOST));
            }
        });
        assertEquals("0,0 1,0 1,0.7", callOnEdt(field::getText));
        write("Points, m", "0,0");
        assertEquals(List.of(), commands);
        write("Points, m", "0,0 1.5,0");
        assertEquals(
                new ObstacleShape.WallShape(List.of(new Vector2(0, 0), new Vector2(1.5, 0))),
                placed(0).shape());
    }

    /** A file may have such a polygon; its other attributes can be changed. */
    @Test
    void aPolygonWithoutAreaIsRefused() {
        Obstacle flat = new Obstacle(
                "flat",
                new ObstacleShape.PolygonShape(List.of(new Vector2(0, 0), new Vector2(1, 1), new Vector2(0.1, 0.1))),
                new Pose(1, 1, 0));
        Runnable update = () -> show(SampleFrames.frameOf(new Pose(3, 2, 0), flat));
        runOnEdt(() -> {
            update.run();
            canvas.tools().select(List.of("flat"));
            update.run();
        });
        write("Points, m", "0,0 1,1 0.3,0.3");
        assertEquals(List.of(), commands);
        runOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Glossy").doClick(0));
        assertTrue(placed(0).isSpecular());
        write("Points, m", "0,0 1,1 0.3,0.31");
        assertEquals(2, commands.size());
    }

    @Test
    void severalAreAlignedByTheirEdges() {
        select("crate", "vase");
        runOnEdt(() -> ComponentFinder.find(panel, JButton.class, "Left").doClick(0));
        assertEquals(1, commands.size(), "the crate is in place");
        assertEquals(1.0 + 0.15, ((Command.MoveObstacle) commands.get(0)).pose().x(), 1e-9);
        assertFalse(callOnEdt(
                () -> ComponentFinder.find(panel, JButton.class, "Spread x").isEnabled()));
    }

    @Test
    void obstaclesAreAlignedWhereTheRunWillPutThem() {
        select("crate", "vase");
        runOnEdt(() -> {
            sender.send(new Command.MoveObstacle("crate", new Pose(2.3, 2.9, 0)));
            ComponentFinder.find(panel, JButton.class, "Left").doClick(0);
        });
        assertEquals(2, commands.size(), "the crate is in place");
        assertEquals(2.0 + 0.15, ((Command.MoveObstacle) commands.get(1)).pose().x(), 1e-9);
    }

    @Test
    void theOuterOnesStayWhenCentresAreSpread() {
        List<Command> moves = ObstacleArrangement.SPREAD_X.commands(List.of(CAT, CRATE, VASE));
        assertEquals(1, moves.size());
        Command.MoveObstacle move = (Command.MoveObstacle) moves.get(0);
        assertEquals("vase", move.obstacle());
        assertEquals((1.3 + 5) / 2, move.pose().x(), 1e-9);
        assertEquals(List.of(), ObstacleArrangement.SPREAD_Y.commands(List.of(CAT, CRATE)));
    }

    @Test
    void arrangedPositionsHaveFewDecimals() {
        List<Obstacle> rotated = Stream.of(CRATE, VASE, FENCE)
                .map(each -> each.withPose(
                        new Pose(each.pose().x() / 3, 0.123456789, each.pose().x())))
                .toList();
        for (ObstacleArrangement arrangement : ObstacleArrangement.values()) {
            for (Command command : arrangement.commands(rotated)) {
                Command.MoveObstacle move = (Command.MoveObstacle) command;
                Pose before = rotated.stream()
                        .filter(each -> each.id().equals(move.obstacle()))
                        .findFirst()
                        .orElseThrow()
                        .pose();
                assertTrue(
                        DecimalText.format(move.pose().x()).length() <= 8
                                || move.pose().x() == before.x(),
                        move + " by " + arrangement);
                assertTrue(
                        DecimalText.format(move.pose().y()).length() <= 8
                                || move.pose().y() == before.y(),
                        move + " by " + arrangement);
            }
        }
    }

    @Test
    void everyArrangementLeavesWhatItHasArranged() {
        for (ObstacleArrangement arrangement : ObstacleArrangement.values()) {
            List<Obstacle> arranged = new ArrayList<>(List.of(CRATE, VASE, FENCE));
            for (Command command : arrangement.commands(arranged)) {
                Command.MoveObstacle move = (Command.MoveObstacle) command;
                arranged.replaceAll(each -> each.id().equals(move.obstacle()) ? each.withPose(move.pose()) : each);
            }
            for (Command again : arrangement.commands(arranged)) {
                Command.MoveObstacle move = (Command.MoveObstacle) again;
                Pose now = arranged.stream()
                        .filter(each -> each.id().equals(move.obstacle()))
                        .findFirst()
                        .orElseThrow()
                        .pose();
                assertEquals(0, now.position().distanceTo(move.pose().position()), 1e-9, arrangement.name());
            }
        }
    }

    @Test
    void aListOfPointsIsReadBack() {
        List<Vector2> points = List.of(new Vector2(0.125, -3), new Vector2(1e-7, 12.5));
        assertEquals(Optional.of(points), PointsField.parse(PointsField.format(points)));
        for (String wrong : Set.of("", "1", "1,2,3", "1,2 ;", "200000,0")) {
            assertEquals(Optional.empty(), PointsField.parse(wrong), wrong);
        }
    }

    private String text(String name) {
        return callOnEdt(
                () -> ComponentFinder.find(panel, JTextField.class, name).getText());
    }

    @Test
    void fieldsThatDoNotApplyShowNothing() {
        select("cat");
        assertEquals(List.of("5.00", "0.20", "0.40"), List.of(text("x, m"), text("Radius x, m"), text("Speed, m/s")));
        assertTrue(callOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Return to first waypoint")
                .isSelected()));
        select("vase");
        assertEquals(List.of("4.10", "0.15", ""), List.of(text("x, m"), text("Radius, m"), text("Speed, m/s")));
        assertFalse(callOnEdt(() -> ComponentFinder.find(panel, JCheckBox.class, "Return to first waypoint")
                .isSelected()));
        select();
        assertEquals(
                List.of("", "", "", ""), List.of(text("x, m"), text("y, m"), text("Heading, °"), text("Width, m")));
        select("crate");
        assertEquals(
                List.of("1.30", "2.90", "0", "0.60"),
                List.of(text("x, m"), text("y, m"), text("Heading, °"), text("Width, m")));
        assertEquals(List.of(), commands);
    }
}
