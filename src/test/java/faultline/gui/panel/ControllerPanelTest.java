package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.GainRule;
import faultline.control.PdGains;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.WallSide;
import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.FieldExtremes;
import faultline.gui.action.UiAction;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.TaskFailures;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.robot.MotorSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Component;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFormattedTextField;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The controller panel with a run behind it, without a display. */
@ExtendWith(EdtChecker.class)
class ControllerPanelTest {

    @TempDir
    private Path folder;

    private Workspace workspace;
    private RunController run;
    private DocumentStore documents;
    private CommandSender sender;
    private UndoController undo;
    private ControllerPanel panel;
    private final List<String> choices = new ArrayList<>();

    @BeforeEach
    void open() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            workspace = new Workspace();
            run = new RunController(workspace);
            documents = new DocumentStore(workspace);
            sender = new CommandSender(run::send);
            undo = new UndoController(sender, () -> {});
            undo.follow(workspace, run);
            workspace.addListener(new TaskFailures());
            panel = new ControllerPanel(
                    sender,
                    new ScenarioEditor(run, undo),
                    new ControlPanel.PanelActions(
                            null,
                            UiAction.of("chooseController", () -> choices.add("another")),
                            UiAction.of("scenarioController", () -> choices.add("the scenario's"))));
            documents.open(Path.of("scenarios/right-hand.xml"));
        });
        await("the scenario", spec -> true);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    /** Waits for a frame whose controller meets a condition, and shows every frame on the way. */
    private void await(String what, Predicate<ControllerSpec> condition) {
        SessionFrames.awaitFrame(workspace, what, frame -> {
            sender.pendingEdits().setRobot(frame.snapshot().robot());
            panel.setSettings(
                    frame.controller(),
                    frame.controllerName(),
                    workspace.scenario().orElseThrow().setup());
            return condition.test(frame.controller());
        });
    }

    @Test
    void everyNumberThatAFieldAllowsCanBeSaved() {
        FieldExtremes.enterAll(panel, () -> {
            Await.until("the commands", () -> {
                SessionFrames.poll(workspace);
                return !workspace.awaitsCommands() && workspace.task().isEmpty();
            });
            Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
            assertDoesNotThrow(edited::toBytes);
        });
    }

    private static WallFollowing follower(ControllerSpec spec) {
        return (WallFollowing) spec;
    }

    private void type(String name, double value) {
        runOnEdt(() -> ComponentFinder.find(panel, JSpinner.class, name).setValue(value));
    }

    private void choose(String name, int index) {
        runOnEdt(() -> ComponentFinder.find(panel, JComboBox.class, name).setSelectedIndex(index));
    }

    private double shown(String name) {
        return callOnEdt(() ->
                ((Number) ComponentFinder.find(panel, JSpinner.class, name).getValue()).doubleValue());
    }

    private boolean isShown(String name) {
        return callOnEdt(() -> isShown(ComponentFinder.find(panel, JSpinner.class, name)));
    }

    /** Returns whether a component and all components around it in the panel are visible. */
    private boolean isShown(Component part) {
        return part.isVisible() && (part == panel || isShown(part.getParent()));
    }

    @Test
    void aChangeHoldsFromNowIsUndoneAndRedone() {
        double before = shown("Distance, m");
        type("Distance, m", 0.37);
        await("the new distance", spec -> follower(spec).distance() == 0.37);
        assertEquals(WallSide.RIGHT, callOnEdt(() -> follower(
                        workspace.scenario().orElseThrow().setup().controller())
                .side()));
        runOnEdt(undo::undo);
        await("the old distance", spec -> follower(spec).distance() == before);
        assertEquals(before, shown("Distance, m"));
        assertFalse(callOnEdt(workspace::isChanged));
        runOnEdt(undo::redo);
        await("the new distance again", spec -> follower(spec).distance() == 0.37);
    }

    @Test
    void gainsAreShownBeforeTheyAreSetAndSavedWithTheScenario() throws ScenarioException {
        double length = shown("Length, m");
        assertEquals(2 / length, shown("k_d, rad/m"), 1e-3, "k_d = 2 / l");
        double proportional = shown("k_p, rad/s/m");
        type("k_d, rad/m", 14.5);
        await("both gains are fixed", spec -> follower(spec).gainRule().equals(new GainRule.Fixed(proportional, 14.5)));
        runOnEdt(undo::undo);
        await("automatic gains", spec -> follower(spec).gainRule().equals(GainRule.AUTOMATIC));
        choose("Gains", 2);
        PdGains automatic = callOnEdt(() -> PdGains.criticallyDamped(
                length, workspace.scenario().orElseThrow().setup().robot().speed()));
        await("the same gains, fixed", spec -> follower(spec)
                .gainRule()
                .equals(new GainRule.Fixed(automatic.proportional(), automatic.derivative())));
        type("k_d, rad/m", 14.5);
        await(
                "the new gain",
                spec -> follower(spec).gainRule() instanceof GainRule.Fixed fixed && fixed.derivative() == 14.5);
        Path file = folder.resolve("tuned.xml");
        runOnEdt(() -> documents.save(file, () -> {}));
        Await.until("the scenario is saved", () -> !workspace.isChanged());
        WallFollowing saved = follower(Scenario.load(file).setup().controller());
        assertEquals(14.5, ((GainRule.Fixed) saved.gainRule()).derivative());
    }

    @Test
    void aLengthThatIsEnteredChoosesGainsByLengthAndIsShownWithAllItsDigits() {
        type("Length, m", 0.05662);
        await("gains by length", spec -> follower(spec).gainRule().equals(new GainRule.Length(0.05662)));
        assertEquals("0.05662", callOnEdt(() -> ComponentFinder.find(panel, JFormattedTextField.class, "Length, m")
                .getText()));
        assertEquals(2 / 0.05662, shown("k_d, rad/m"), 1e-3);
    }

    @Test
    void everyThresholdIsAFieldWhoseChangeIsUndoneAndSaved() throws ScenarioException {
        WallFollowing wanted = callOnEdt(
                () -> follower(workspace.scenario().orElseThrow().setup().controller()));
        for (Threshold threshold : Threshold.values()) {
            String name = Messages.get("controller." + threshold.fileName());
            assertEquals(threshold.defaultValue(), shown(name), name);
            double value = threshold.defaultValue() + 0.125;
            type(name, value);
            await(name, spec -> follower(spec).thresholds().get(threshold) == value);
            wanted = wanted.withThreshold(threshold, value);
        }
        Path file = folder.resolve("thresholds.xml");
        runOnEdt(() -> documents.save(file, () -> {}));
        Await.until("the scenario is saved", () -> !workspace.isChanged());
        assertEquals(wanted, Scenario.load(file).setup().controller());
        Thresholds typed = wanted.thresholds();
        click("Defaults");
        await("the defaults", spec -> follower(spec).thresholds().equals(Thresholds.DEFAULT));
        runOnEdt(undo::undo);
        await("the typed values", spec -> follower(spec).thresholds().equals(typed));
        runOnEdt(undo::undo);
        Thresholds earlier = typed.with(Threshold.STEER_THROUGH, Threshold.STEER_THROUGH.defaultValue());
        await("all but the last one", spec -> follower(spec).thresholds().equals(earlier));
    }

    private void click(String text) {
        runOnEdt(() -> ComponentFinder.findAll(panel, JButton.class)
                .filter(button -> text.equals(button.getText()))
                .findFirst()
                .orElseThrow()
                .doClick(0));
    }

    @Test
    void thePeriodIsAFieldAndSaved() throws ScenarioException {
        type("Period, s", 0.04);
        await("the new period", spec -> spec.period() == 0.04);
        Path file = folder.resolve("period.xml");
        runOnEdt(() -> documents.save(file, () -> {}));
        Await.until("the scenario is saved", () -> !workspace.isChanged());
        assertEquals(0.04, Scenario.load(file).setup().controller().period());
    }

    @Test
    void theEventNamesWhatIsNotAsUsual() {
        assertEquals(
                "wall follower, 0.25 m, wall left, automatic gains, equal readings, every 0.05 s, no diagnosis;"
                        + " Wall lost, m: 0.1",
                ControllerText.format(WallFollowing.DEFAULT
                        .withPeriod(0.05)
                        .withDiagnosis(false)
                        .withThreshold(Threshold.LOST_MARGIN, 0.1)));
    }

    @Test
    void anotherKindShowsOnlyItsFields() {
        assertFalse(isShown("Left, V"));
        assertTrue(isShown("Distance, m") && isShown("Length, m") && isShown("Wall lost, m"));
        choose("Controller", 1);
        await("constant voltages", spec -> spec instanceof ControllerSpec.Drive);
        assertTrue(isShown("Left, V") && isShown("Turn rate, °/s"));
        assertFalse(isShown("Distance, m") || isShown("Length, m") || isShown("Wall lost, m"));
        type("Left, V", 1.5);
        await("the new voltage", spec -> spec.equals(new ControllerSpec.Drive(1.5, 1)));
        runOnEdt(undo::undo);
        runOnEdt(undo::undo);
        await("the follower", spec -> spec instanceof WallFollowing);
        assertTrue(isShown("Distance, m"));
        assertFalse(isShown("Left, V"));
    }

    @Test
    void aChosenControllerIsNamedWithButtonsThatChooseAnotherOneOrReturnToTheScenario() {
        String command = "python3 follower.py --fast";
        assertEquals(List.of(), texts("Chosen"));
        runOnEdt(() -> {
            panel.setChosen(command);
            panel.setSettings(
                    new ControllerSpec.Extern(0),
                    "",
                    workspace.scenario().orElseThrow().setup());
        });
        assertEquals(List.of("Chosen"), texts("Chosen"));
        assertEquals(List.of(command), texts(command));
        assertFalse(isShown("Distance, m") || isShown("Left, V"));
        click("Choose controller…");
        click("Scenario controller");
        assertEquals(List.of("another", "the scenario's"), choices);
        runOnEdt(() -> panel.setChosen(""));
        await("the follower again", spec -> spec instanceof WallFollowing);
        assertEquals(List.of(), texts("Chosen"));
    }

    @Test
    void aChangeOfTheDriveIsSimulatedAgainAndUndone() {
        double before = shown("Turn rate, °/s");
        type("Turn rate, °/s", before + 20);
        SessionFrames.awaitFrame(
                workspace,
                "the run is simulated again",
                frame -> StrictMath.toDegrees(frame.snapshot().robot().turnRate()) > before + 19);
        runOnEdt(undo::undo);
        SessionFrames.awaitFrame(
                workspace,
                "the old turn rate",
                frame -> StrictMath.toDegrees(frame.snapshot().robot().turnRate()) < before + 1);
    }

    @Test
    void aDriveThatAFileCannotHoldIsNotEntered() throws ScenarioException {
        type("Speed, m/s/V", 9);
        SessionFrames.awaitFrame(
                workspace,
                "the faster wheels",
                frame -> frame.snapshot().robot().motor().speedConstant() == 9);
        await("the new limits", spec -> true);
        assertEquals("0.001 to 111.111", limits("Voltage, V"));
        assertEquals("0.001 to 10", limits("Speed, m/s/V"));
        type("Voltage, V", 111.111);
        SessionFrames.awaitFrame(
                workspace,
                "the higher voltage",
                frame -> frame.snapshot().robot().motor().maxVoltage() == 111.111);
        await("the new limits", spec -> true);
        assertEquals("0.001 to 9", limits("Speed, m/s/V"));
        Path file = folder.resolve("fast.xml");
        runOnEdt(() -> documents.save(file, () -> {}));
        Await.until("the scenario is saved", () -> !workspace.isChanged());
        assertEquals(999.999, Scenario.load(file).setup().robot().motor().maxSpeed(), 1e-9);
    }

    /** The limit of each value depends on the other one, so other motors have other limits. */
    @Test
    void otherMotorsAreShownWithoutAnEdit() {
        MotorSpec fast = new MotorSpec(0.05, 2, 400);
        runOnEdt(() -> {
            Scenario open = workspace.scenario().orElseThrow();
            documents.create(
                    open.withSetup(open.setup().withRobot(open.setup().robot().withMotor(fast))));
        });
        SessionFrames.awaitFrame(
                workspace,
                "the other motors",
                frame -> frame.snapshot().robot().motor().equals(fast));
        await("the new limits", spec -> true);
        assertEquals("0.001 to 500", limits("Voltage, V"));
        assertEquals(
                fast,
                callOnEdt(
                        () -> workspace.scenario().orElseThrow().setup().robot().motor()));
        assertFalse(callOnEdt(undo::canUndo));
    }

    private String limits(String field) {
        return callOnEdt(
                () -> ComponentFinder.find(panel, NumberSpinner.class, field).limitsText());
    }

    @Test
    void theNameThatAControllerGivesItselfIsShownAsItIs() {
        assertEquals(List.of(), texts("Name"));
        String markup = "<html><b>my follower";
        runOnEdt(() -> panel.setSettings(
                new ControllerSpec.Extern(0),
                markup,
                workspace.scenario().orElseThrow().setup()));
        assertEquals(List.of(markup), texts(markup));
        assertEquals(List.of("Name"), texts("Name"));
        assertNull(callOnEdt(() -> labels(markup).findFirst().orElseThrow().getClientProperty("html")));
        await("the follower again", spec -> true);
        assertEquals(List.of(), texts("Name"));
    }

    private List<String> texts(String text) {
        return callOnEdt(() -> labels(text).map(JLabel::getText).toList());
    }

    /** Returns the visible labels with a text. */
    private Stream<JLabel> labels(String text) {
        return ComponentFinder.findAll(panel, JLabel.class)
                .filter(label -> isShown(label) && text.equals(label.getText()));
    }
}
