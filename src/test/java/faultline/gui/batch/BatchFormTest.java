package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.external.ControllerChoice;
import faultline.external.ControllerNames;
import faultline.gui.ComponentFinder;
import faultline.gui.form.FormDialog;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.FieldOutline;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.Point;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import javax.swing.AbstractButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BatchFormTest {

    private Scenario scenario;
    private BatchForm form;

    @BeforeEach
    void create() throws Exception {
        scenario = Scenario.load(Path.of("scenarios/corridor-with-visitor.xml"));
        form = callOnEdt(() -> new BatchForm(scenario));
    }

    private void click(String text) {
        runOnEdt(() -> ComponentFinder.findAll(form, AbstractButton.class)
                .filter(button -> text.equals(button.getText()))
                .findFirst()
                .orElseThrow()
                .doClick());
    }

    private void type(String name, String text) {
        runOnEdt(() -> ComponentFinder.find(form, JTextField.class, name).setText(text));
    }

    private BatchPlan plan() {
        return callOnEdt(form::plan);
    }

    private String labels() {
        return callOnEdt(() ->
                ComponentFinder.findAll(form, JLabel.class).map(JLabel::getText).collect(Collectors.joining("|")));
    }

    @Test
    void theFirstPlanIsOneOfTheOpenScenario() {
        BatchPlan plan = plan();
        assertEquals(scenario, plan.scenario());
        assertEquals(scenario.setup().duration(), plan.duration());
        assertEquals(scenario.setup().seed(), plan.firstSeed());
        assertEquals(
                scenario.setup().robot().sensors().stream()
                        .map(sensor -> sensor.id())
                        .toList(),
                plan.sensors());
        assertEquals(List.of(new BatchPlan.FaultValues("stuck", "0.2..0.8")), plan.faults());
        assertEquals(Optional.empty(), callOnEdt(form::findProblem));
        long expected = 10L * (plan.sensors().size() + 1);
        assertTrue(labels().contains("|Runs: " + expected), labels());
    }

    @ParameterizedTest
    @CsvSource({
        "0.001, 0.0001..0.0005",
        "0.002, 0..0.001",
        "0.003, 0..0.001",
        "0.5, 0.05..0.25",
        "2, 0..1",
        "3, 0..1",
        "180, 18..90"
    })
    void theFirstPlanHasFaultsInTheFirstHalfOfTheRun(double duration, String onset) {
        Scenario shortRun = scenario.withSetup(scenario.setup().withDuration(duration));
        form = callOnEdt(() -> new BatchForm(shortRun));
        assertEquals(onset, plan().onset());
        assertFalse(labels().contains("|Faults may start after the end"), labels());
    }

    @Test
    void aSeedThatNoPlanHasIsNotSuggested() {
        for (long seed : new long[] {Long.MIN_VALUE, Long.MAX_VALUE, -CampaignPlan.MAX_SEED - 1}) {
            Scenario seeded = scenario.withSetup(scenario.setup().withSeed(seed));
            form = callOnEdt(() -> new BatchForm(seeded));
            assertEquals(1, plan().firstSeed());
        }
        Scenario least = scenario.withSetup(scenario.setup().withSeed(-CampaignPlan.MAX_SEED));
        form = callOnEdt(() -> new BatchForm(least));
        assertEquals(-CampaignPlan.MAX_SEED, plan().firstSeed());
    }

    @Test
    void aRemarkSaysThatFaultsMayStartAfterTheEnd() {
        String remark = "|Faults may start after the end";
        String duration = Long.toString((long) scenario.setup().duration());
        assertFalse(labels().contains(remark), labels());
        type("Start of the fault", "5.." + duration);
        assertTrue(labels().contains(remark), labels());
        type("Start of the fault", "5 10");
        assertFalse(labels().contains(remark), labels());
        type("Start of the fault", "5 1e9");
        assertTrue(labels().contains(remark), labels());
        click("None");
        assertFalse(labels().contains(remark), "there are no faults");
    }

    @Test
    void aRemarkSaysThatTheFaultsOfTheScenarioAreInAllRuns() throws Exception {
        String remark = "|The scenario's own faults act in all runs";
        assertFalse(labels().contains(remark), labels());
        Scenario faulty = Scenario.load(Path.of("scenarios/every-fault.xml"));
        form = callOnEdt(() -> new BatchForm(faulty));
        assertTrue(labels().contains(remark), labels());
    }

    @Test
    void aRemarkSaysThatTheTimelineOverrulesTheDiagnosis() {
        ControllerSpec.BuiltIn same = (ControllerSpec.BuiltIn) scenario.setup().controller();
        open(scenario.withSetup(
                scenario.setup().withTimeline(List.of(new TimedCommand(0.5, new Command.ConfigureController(same))))));
        assertFalse(labels().contains("the timeline sets"), labels());
        choose(DiagnosisChoice.ON);
        assertFalse(labels().contains("the timeline sets"), "it sets the same");
        choose(DiagnosisChoice.BOTH);
        assertTrue(labels().contains("|From 0.50 s on, the timeline sets the diagnosis|"), labels());
        choose(DiagnosisChoice.OFF);
        assertTrue(labels().contains("|From 0.50 s on, the timeline sets the diagnosis|"), labels());
        Command drive = new Command.ConfigureController(new ControllerSpec.Drive(1, 1));
        open(scenario.withSetup(scenario.setup().withTimeline(List.of(new TimedCommand(2, drive)))));
        choose(DiagnosisChoice.OFF);
        assertTrue(labels().contains("|From 2.00 s on, the timeline sets the controller|"), labels());
    }

    private void open(Scenario changed) {
        form = callOnEdt(() -> new BatchForm(changed));
    }

    private void choose(DiagnosisChoice diagnosis) {
        runOnEdt(() -> ComponentFinder.find(form, JComboBox.class, "Diagnosis").setSelectedItem(diagnosis));
    }

    @Test
    void theControllerIsThatOfTheScenarioUnlessAnotherOneIsChosen() {
        assertEquals(ControllerChoice.SCENARIO, callOnEdt(form::controllerChoice));
        assertTrue(callOnEdt(
                () -> ComponentFinder.find(form, JComboBox.class, "Diagnosis").isEnabled()));
    }

    @Test
    void allKindsHaveValuesThatTheScenarioTakes(@TempDir Path folder) throws Exception {
        click("All");
        click("Default values");
        assertEquals(17, plan().faults().size());
        assertTrue(plan().faults().contains(new BatchPlan.FaultValues("stuck", "0.4")));
        click("Drawn values");
        assertEquals(plan().runCount().orElseThrow(), plan().prepare(folder).runCount());
    }

    @Test
    void aKindAndItsValueAreExplained() {
        runOnEdt(() -> {
            JCheckBox kind = ComponentFinder.findAll(form, JCheckBox.class)
                    .filter(box -> box.getText().equals("quantised"))
                    .findFirst()
                    .orElseThrow();
            assertEquals("Every distance is rounded to a multiple of a step", kind.getToolTipText());
            JTextField value = ComponentFinder.find(form, JTextField.class, "Value of the fault: quantised");
            assertTrue(value.getToolTipText().startsWith("Step, m. A number such as"), value.getToolTipText());
        });
    }

    @Test
    void severalValuesMakeMoreRunsAndAWrongOneIsReported() {
        int sensors = plan().sensors().size();
        type("Start of the fault", "5 10 20");
        assertEquals(OptionalLong.of(10L * (3L * sensors + 1)), plan().runCount());
        type("Value of the fault: stuck", "0.1..0.5/5");
        assertEquals(OptionalLong.of(10L * (15L * sensors + 1)), plan().runCount());
        type("Start of the fault", "5..");
        String syntax = "A number such as 0.4, a range to draw from such as 0.2..0.8, or several numbers with spaces "
                + "between them";
        assertEquals("5.. is not allowed. " + syntax, problemOf("Start of the fault"));
        assertTrue(labels().contains("A value is not in the expected format"), labels());
        type("Start of the fault", "");
        assertEquals("A value is missing. " + syntax, problemOf("Start of the fault"));
    }

    @Test
    void aWrongValueIsMarked() {
        runOnEdt(Theme.LIGHT::install);
        form = callOnEdt(() -> new BatchForm(scenario));
        type("Value of the fault: stuck", "0.8..0.2");
        type("Value of the fault: quantised", "0.8..0.2");
        type("Start of the fault", "5..");
        assertTrue(isMarked("Value of the fault: stuck"));
        assertFalse(isMarked("Value of the fault: quantised"), "the fault is not chosen");
        assertTrue(isMarked("Start of the fault"));
        type("Value of the fault: stuck", "0.2..0.8");
        assertFalse(isMarked("Value of the fault: stuck"));
        click("None");
        assertFalse(isMarked("Start of the fault"), "no fault starts");
    }

    private boolean isMarked(String name) {
        JTextField field = callOnEdt(() -> ComponentFinder.find(form, JTextField.class, name));
        return FieldOutline.colour(field).equals(Theme.LIGHT.colours().warning());
    }

    @Test
    void aReversedRangeHasASentenceOfItsOwn() {
        type("Value of the fault: stuck", "0.8..0.2");
        String rule = "A range must begin with its smaller number";
        assertTrue(labels().contains("|" + rule + "|"), labels());
        assertEquals("0.8..0.2 is not allowed. " + rule, problemOf("Value of the fault: stuck"));
    }

    /** A fraction was shown rounded and used truncated. */
    @Test
    void aFractionOfARunIsRefused() {
        for (String field : List.of("Number of seeds", "First seed", "Threads")) {
            type(field, "10.6");
            String refusal = "10.6 is not allowed. " + field + ": whole numbers, ";
            assertTrue(problemOf(field).startsWith(refusal), problemOf(field));
            type(field, "10");
            assertEquals(Optional.empty(), callOnEdt(form::findProblem), field);
        }
        assertEquals(10, plan().seeds());
        assertEquals(10, plan().firstSeed());
        assertEquals(10, callOnEdt(form::jobs));
    }

    @Test
    void aWrongNumberOfAFaultGetsTheFocusIfTheFaultIsChosen() {
        type("Value of the fault: stuck", "1..");
        type("Value of the fault: quantised", "2..");
        String problem = problemOf("Value of the fault: stuck");
        assertTrue(problem.startsWith("1.. is not allowed. "), problem);
        type("Value of the fault: stuck", "0.4");
        assertEquals(Optional.empty(), callOnEdt(form::findProblem));
    }

    @Test
    void moreRunsThanAPlanMayHaveAreReportedBeforeTheStart() {
        List<BatchPlan.FaultValues> faults =
                Collections.nCopies(17, new BatchPlan.FaultValues("stuck", "0.1..1/100000"));
        List<String> sensors = Collections.nCopies(1008, "left");
        BatchPlan huge = new BatchPlan(
                scenario, 1, 1_000_000, 100, false, DiagnosisChoice.BOTH, true, faults, "0.1..1/100000", sensors);
        assertEquals(OptionalLong.of(Long.MAX_VALUE), huge.runCount());
        type("Start of the fault", "1..20/1000");
        type("Value of the fault: stuck", "0.1..0.5/500");
        String sentence = "Too many runs: at most 10000000";
        assertEquals(sentence, problemOf("Number of seeds"));
        assertTrue(labels().contains("|" + sentence + "|"), labels());
        type("Value of the fault: stuck", "0.3");
        assertEquals(Optional.empty(), callOnEdt(form::findProblem));
        assertFalse(labels().contains(sentence), labels());
    }

    /** Returns the sentence about a field, which gets the focus. */
    private String problemOf(String name) {
        FormDialog.FormProblem problem = callOnEdt(() -> form.findProblem().orElseThrow());
        assertEquals(callOnEdt(() -> ComponentFinder.find(form, JTextField.class, name)), problem.field());
        return problem.sentence();
    }

    @Test
    void aNarrowDialogScrollsTheFieldsDownOnly() {
        for (Language language : Language.values()) {
            form = callOnEdt(() -> {
                Messages.setLanguage(language);
                return new BatchForm(scenario);
            });
            for (int width : new int[] {600, 1050}) {
                runOnEdt(() -> layOut(width));
                JViewport viewport = callOnEdt(() -> ComponentFinder.findAll(form, JViewport.class)
                        .findFirst()
                        .orElseThrow());
                assertTrue(
                        viewport.getView().getWidth() <= viewport.getWidth(),
                        language + " " + width + " " + viewport.getView().getWidth());
                assertEquals(width == 600, viewport.getView().getHeight() > viewport.getHeight());
            }
        }
    }

    @Test
    void aWideDialogShowsTheFaultsInTwoColumns() {
        runOnEdt(() -> form.setSize(1050, 600));
        for (int pass = 0; pass < 2; pass++) {
            runOnEdt(() -> ComponentFinder.layOut(form));
        }
        assertEquals(locationOf("off, no reading").y, locationOf("dropout in bursts").y, 1);
        assertTrue(locationOf("dropout in bursts").x > locationOf("Value of the fault: stuck").x);
        assertEquals(locationOf("front").y, locationOf("rear-left").y, "four sensors in a row");
        assertTrue(locationOf("front").y < locationOf("rear").y);
        assertTrue(locationOf("front").y > locationOf("quantised").y, "below the faults");
        runOnEdt(() -> form.setSize(600, 600));
        for (int pass = 0; pass < 2; pass++) {
            runOnEdt(() -> ComponentFinder.layOut(form));
        }
        assertTrue(locationOf("dropout in bursts").y > locationOf("Value of the fault: stuck").y);
    }

    @Test
    void sensorsWithLongIdsAreInFewerColumns() {
        form = callOnEdt(() -> new BatchForm(scenario.withSetup(scenario.setup()
                .withRobot(scenario.setup()
                        .robot()
                        .withSensors(scenario.setup().robot().sensors().stream()
                                .map(sensor -> sensor.withId(sensor.id() + "-of-the-upper-deck"))
                                .toList())))));
        runOnEdt(() -> form.setSize(1050, 600));
        for (int pass = 0; pass < 2; pass++) {
            runOnEdt(() -> ComponentFinder.layOut(form));
        }
        assertTrue(locationOf("front-of-the-upper-deck").y < locationOf("rear-left-of-the-upper-deck").y);
        assertEquals(
                locationOf("off, no reading").y, locationOf("dropout in bursts").y, 1, "the faults keep their columns");
    }

    /** Returns where a check box or a field is in the form. */
    private Point locationOf(String name) {
        return callOnEdt(() -> {
            JComponent part = ComponentFinder.find(form, JComponent.class, name);
            return SwingUtilities.convertPoint(part, 0, 0, form);
        });
    }

    private void layOut(int width) {
        form.setSize(width, 600);
        form.doLayout();
        JScrollPane scroll =
                ComponentFinder.findAll(form, JScrollPane.class).findFirst().orElseThrow();
        scroll.doLayout();
        scroll.getViewport().doLayout();
    }

    @AfterEach
    void restoreLanguage() {
        runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
    }

    @Test
    void theControllerOfTheWindowIsSelectedWhenItIsOffered() {
        ControllerChoice mine = new ControllerChoice("my-follower", List.of(Path.of("mine.jar")));
        runOnEdt(() -> form.setChosen(mine, false));
        assertEquals(
                "my-follower", ControllerNames.typeOf(plan().scenario().setup().controller()));
        assertEquals(mine, callOnEdt(form::controllerChoice));
        assertFalse(callOnEdt(
                () -> ComponentFinder.find(form, JComboBox.class, "Diagnosis").isEnabled()));
        choose(1);
        assertEquals(scenario, plan().scenario());
        runOnEdt(() -> form.setChosen(mine, false));
        assertEquals(scenario, plan().scenario(), "the user has chosen another one");
        choose(0);
        runOnEdt(() -> form.setChosen(ControllerChoice.SCENARIO, false));
        assertEquals(mine, callOnEdt(form::controllerChoice), "as after a run has been opened");
    }

    private void choose(int index) {
        runOnEdt(() -> ComponentFinder.find(form, JComboBox.class, "Controller").setSelectedIndex(index));
    }

    @Test
    void theFormSaysWhatToKnowAboutAController() throws Exception {
        assertFalse(labels().contains("cannot drive a batch"));
        runOnEdt(() -> form.setChosen(ControllerChoice.of("python3 robot.py"), true));
        assertTrue(labels().contains("|The chosen program cannot drive a batch|"), labels());
        assertEquals(scenario, plan().scenario());
        runOnEdt(() -> form.setChosen(ControllerChoice.of("my-follower"), false));
        assertFalse(labels().contains("cannot drive a batch"));
    }

    @Test
    void theDistanceOfAChosenControllerIsThatOfTheScenario() throws Exception {
        ControllerSpec.WallFollowing far = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.4);
        Scenario other = scenario.withSetup(scenario.setup().withController(far));
        form = callOnEdt(() -> new BatchForm(other));
        runOnEdt(() -> form.setChosen(ControllerChoice.of("my-follower"), false));
        assertEquals(
                OptionalDouble.of(0.4), plan().scenario().setup().controller().wantedDistance());
    }
}
