package faultline.gui.properties;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.form.FormDialog.FormProblem;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenarios;
import faultline.world.Clearance;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** New scenarios, and the properties of the open one, without a display. */
@ExtendWith(EdtChecker.class)
class PropertiesTest {

    @TempDir
    private Path folder;

    @BeforeEach
    void installTheme() {
        runOnEdt(Theme.LIGHT::install);
    }

    @ParameterizedTest
    @EnumSource
    void everyTemplateIsAScenarioThatHoldsWhatItExpects(ScenarioTemplate template) throws IOException {
        Scenario scenario = template.create();
        assertEquals(
                Optional.empty(),
                Clearance.findObstruction(
                        scenario.setup().world(),
                        scenario.setup().robot(),
                        scenario.setup().start()));
        Path file = folder.resolve("new.xml");
        scenario.save(file);
        assertEquals(List.of(), scenario.run().unmetExpectations());
    }

    /** A dialog on a screen of 800 by 600 has this width between its borders and beside a scroll bar. */
    @ParameterizedTest
    @EnumSource(Language.class)
    void theFormIsAsWideAsASmallScreenWithLargeText(Language language) {
        runOnEdt(() -> {
            TextSize.LARGEST.install();
            Theme.LIGHT.install();
            Messages.setLanguage(language);
            try {
                int width = new PropertiesForm().getPreferredSize().width;
                assertTrue(width <= 720, width + " pixels");
            } finally {
                TextSize.NORMAL.install();
                Theme.LIGHT.install();
                Messages.setLanguage(Language.ENGLISH);
            }
        });
    }

    @Test
    void theFormKeepsTheScenariosThatShipWithTheProgram() throws Exception {
        for (String name : ShippedScenarios.names()) {
            Scenario scenario = Scenario.loadShipped(name);
            ScenarioProperties shown = callOnEdt(() -> {
                PropertiesForm form = new PropertiesForm();
                form.setScenario(scenario);
                assertEquals(Optional.empty(), form.findProblem(scenario));
                return form.properties();
            });
            assertEquals(ScenarioProperties.of(scenario), shown, name);
            assertEquals(scenario, shown.applyTo(scenario));
        }
    }

    @Test
    void aChosenFinalStateReplacesThatOfAnotherController() {
        Expectation.Condition foreign = new Expectation.FinalState(ControllerState.of("dock"));
        Expectation expected = callOnEdt(() -> {
            ExpectationForm form = new ExpectationForm();
            form.setExpectation(new Expectation(List.of(foreign)), List.of());
            assertEquals(List.of(foreign), form.expectation().conditions());
            ComponentFinder.find(form, JCheckBox.class, "Ends in").doClick();
            return form.expectation();
        });
        assertEquals(List.of(new Expectation.FinalState(FollowerState.SEARCH)), expected.conditions());
    }

    @Test
    void expectedStatesKeepTheirOrder() {
        List<Expectation.Condition> shown = Stream.of(
                        FollowerState.SEARCH, ControllerState.of("dock"), FollowerState.FOLLOW, FollowerState.ALIGN)
                .<Expectation.Condition>map(Expectation.VisitedState::new)
                .toList();
        runOnEdt(() -> {
            ExpectationForm form = new ExpectationForm();
            form.setExpectation(new Expectation(shown), List.of());
            assertEquals(shown, form.expectation().conditions());
            for (FollowerState state : List.of(FollowerState.ROUND, FollowerState.FOLLOW)) {
                ComponentFinder.find(form, JCheckBox.class, StateText.name(state))
                        .doClick();
            }
            assertEquals(
                    List.of(
                            shown.get(0),
                            shown.get(1),
                            shown.get(3),
                            new Expectation.VisitedState(FollowerState.ROUND)),
                    form.expectation().conditions());
        });
    }

    @ParameterizedTest
    @CsvSource({"false, must not occur", "true, must occur"})
    @SuppressWarnings("unchecked")
    void theFormSaysWhatIsExpectedOfACollision(boolean wanted, String text) {
        String shown = callOnEdt(() -> {
            ExpectationForm form = new ExpectationForm();
            form.setExpectation(new Expectation(List.of(new Expectation.Collides(wanted))), List.of());
            JComboBox<Object> choice = ComponentFinder.find(form, JComboBox.class, "Collision");
            JLabel row = (JLabel) choice.getRenderer()
                    .getListCellRendererComponent(new JList<>(), choice.getSelectedItem(), 0, false, false);
            return row.getText();
        });
        assertEquals(text, shown);
    }

    @Test
    void onlyStatesThatTheControllerHasCanBeExpected() throws IOException {
        Scenario corridor = ScenarioTemplate.CORRIDOR.create();
        Scenario driven = corridor.withSetup(corridor.setup().withController(new ControllerSpec.Drive(1, 1)));
        String follow = StateText.name(FollowerState.FOLLOW);
        ScenarioProperties shown = callOnEdt(() -> {
            PropertiesForm form = new PropertiesForm();
            form.setScenario(corridor);
            ComponentFinder.find(form, JCheckBox.class, follow).doClick();
            assertEquals(2, form.properties().expectation().conditions().size());
            form.setScenario(driven);
            for (String box : List.of(follow, "Ends in")) {
                ComponentFinder.find(form, JCheckBox.class, box).doClick();
            }
            return form.properties();
        });
        shown.applyTo(driven).toBytes();
        assertEquals(driven.expectation(), shown.expectation());
    }

    /** Values that are not edited in the form stay the same to the bit. */
    @Test
    void numbersThatAreNotEditedStayAsTheyAre() {
        Scenario room = ScenarioTemplate.FURNISHED_ROOM.create();
        Pose start = new Pose(1.00003, 1.00007, Degrees.toRadians(33.333));
        ScenarioProperties precise = new ScenarioProperties(
                "Hall", "", 2000.00025, 60.33333, true, start, 12.345, 0.0012345, 1, room.expectation());
        ScenarioProperties shown = callOnEdt(() -> {
            PropertiesForm form = new PropertiesForm();
            form.setScenario(precise.applyTo(room));
            form.nameField().setText("Great hall");
            assertEquals(Optional.empty(), form.findProblem(room));
            return form.properties();
        });
        assertEquals(
                new ScenarioProperties(
                        "Great hall", "", 2000.00025, 60.33333, true, start, 12.345, 0.0012345, 1, room.expectation()),
                shown);
    }

    @Test
    void aWorldThatIsTooSmallForTheRobotAndASeedThatIsNoNumberAreRefused() {
        Scenario room = ScenarioTemplate.FURNISHED_ROOM.create();
        runOnEdt(() -> {
            PropertiesForm form = new PropertiesForm();
            form.setScenario(room);
            ComponentFinder.find(form, JTextField.class, "Seed").setText("seven");
            assertEquals("The seed is not a whole number", sentence(form, room));
            ComponentFinder.find(form, JTextField.class, "Seed").setText("\u0667");
            assertEquals("The seed is not a whole number", sentence(form, room), "Arabic digits");
            ComponentFinder.find(form, JTextField.class, "Seed").setText("-9007199254740993");
            assertEquals(Optional.empty(), form.findProblem(room));
            assertEquals(-9007199254740993L, form.properties().seed());
            NumberSpinner tick = ComponentFinder.find(form, NumberSpinner.class, "Tick, s");
            tick.textField().setText("9x");
            assertEquals("9x is not allowed. Tick, s: 0.00001 to 1", sentence(form, room));
            assertEquals("9x", tick.textField().getText(), "nothing is lost");
            tick.textField().setText("0.02");
            assertEquals(Optional.empty(), form.findProblem(room));
            assertEquals(0.02, form.properties().dt());
            NumberSpinner x = ComponentFinder.find(form, NumberSpinner.class, "Start x, m");
            x.setValue(20.0);
            assertEquals("The robot cannot start there: it would overlap the enclosing wall", sentence(form, room));
            x.setWorldValue(room.setup().start().x());
            ComponentFinder.find(form, JSpinner.class, "Width, m").setValue(1.05);
            assertTrue(sentence(form, room).contains("the enclosing wall"));
        });
    }

    private static String sentence(PropertiesForm form, Scenario scenario) {
        return form.findProblem(scenario).orElseThrow().sentence();
    }

    @Test
    void theFocusGoesToTheFieldOfTheSentence() {
        Scenario room = ScenarioTemplate.FURNISHED_ROOM.create();
        runOnEdt(() -> {
            PropertiesForm form = new PropertiesForm();
            form.setScenario(room);
            NumberSpinner width = ComponentFinder.find(form, NumberSpinner.class, "Width, m");
            JTextField seed = ComponentFinder.find(form, JTextField.class, "Seed");
            NumberSpinner x = ComponentFinder.find(form, NumberSpinner.class, "Start x, m");
            width.textField().setText("abc");
            seed.setText("x");
            x.setValue(0.0);
            assertEquals(
                    Optional.of(new FormProblem("abc is not allowed. Width, m: 0.5 to 1000", width.textField())),
                    form.findProblem(room));
            width.textField().setText(" ");
            assertEquals("A value is missing. Width, m: 0.5 to 1000", sentence(form, room));
            width.textField().setText("6");
            assertEquals(Optional.of(new FormProblem("The seed is not a whole number", seed)), form.findProblem(room));
            seed.setText("1");
            assertEquals(x.textField(), form.findProblem(room).orElseThrow().field());
        });
    }

    @Test
    void propertiesAreEditedUndoneAndRedone() {
        Workspace workspace = callOnEdt(Workspace::new);
        RunController run = callOnEdt(() -> new RunController(workspace));
        UndoController undo = callOnEdt(() -> new UndoController(new CommandSender(run::send), () -> {}));
        runOnEdt(() -> new DocumentStore(workspace).create(ScenarioTemplate.CORRIDOR.create()));
        Await.until("the new scenario", () -> workspace.scenario().isPresent());
        assertTrue(callOnEdt(workspace::isChanged), "a new scenario has not been saved");
        ScenarioProperties before =
                callOnEdt(() -> ScenarioProperties.of(workspace.scenario().orElseThrow()));
        ScenarioProperties after = new ScenarioProperties(
                "Long corridor",
                "With a seed",
                14,
                before.height(),
                true,
                new Pose(1.5, before.start().y(), Degrees.toRadians(30)),
                42,
                0.02,
                99,
                new Expectation(List.of(new Expectation.VisitedState(FollowerState.FOLLOW))));
        runOnEdt(() -> ScenarioActions.edit(new ScenarioEditor(run, undo), before, after));
        await(workspace, after);
        SessionFrames.awaitFrame(
                workspace,
                "the world has its new size",
                frame -> frame.snapshot().width() == 14);
        runOnEdt(undo::undo);
        await(workspace, before);
        runOnEdt(undo::redo);
        await(workspace, after);
        assertFalse(callOnEdt(() -> undo.redoName().isPresent()));
        runOnEdt(workspace::close);
    }

    /** Without a controller, the scenario expects no states. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void expectedStatesReturnWhenEverythingIsUndone(boolean expectation) throws IOException {
        Scenario scenario = ScenarioTemplate.CORRIDOR
                .create()
                .withExpectation(new Expectation(List.of(
                        new Expectation.Collides(false),
                        new Expectation.VisitedState(FollowerState.FOLLOW),
                        new Expectation.VisitedState(FollowerState.SEARCH),
                        new Expectation.FinalState(FollowerState.FOLLOW))));
        Workspace workspace = callOnEdt(Workspace::new);
        RunController run = callOnEdt(() -> new RunController(workspace));
        CommandSender sender = callOnEdt(() -> new CommandSender(run::send));
        UndoController undo = callOnEdt(() -> new UndoController(sender, () -> {}));
        runOnEdt(() -> {
            undo.follow(workspace, run);
            new DocumentStore(workspace).create(scenario);
        });
        SessionFrames.awaitScenario(workspace);
        runOnEdt(() -> sender.send(new Command.ConfigureController(new ControllerSpec.None())));
        awaitRest(workspace);
        runOnEdt(() -> {
            Scenario open = workspace.scenario().orElseThrow();
            assertEquals(1, open.expectation().conditions().size());
            Scenario renamed = open.withName("Other name");
            ScenarioActions.edit(
                    new ScenarioEditor(run, undo),
                    ScenarioProperties.of(open),
                    ScenarioProperties.of(expectation ? renamed.withExpectation(Expectation.NONE) : renamed));
        });
        awaitRest(workspace);
        runOnEdt(undo::undo);
        awaitRest(workspace);
        runOnEdt(undo::undo);
        awaitRest(workspace);
        assertEquals(scenario, callOnEdt(() -> workspace.scenario().orElseThrow()));
        runOnEdt(workspace::close);
    }

    /** With a sweep alone, the states of the follower are hidden. */
    @ParameterizedTest
    @CsvSource({
        "FOLLOW SEARCH TURN, FOLLOW TURN, FOLLOW, FOLLOW SEARCH",
        "FOLLOW SEARCH TURN, FOLLOW TURN, TURN, SEARCH TURN",
        "FOLLOW SEARCH TURN, FOLLOW TURN, FOLLOW TURN ROUND, FOLLOW SEARCH TURN ROUND",
        "FOLLOW TURN SEARCH, FOLLOW TURN, TURN, TURN SEARCH",
        "FOLLOW SEARCH, FOLLOW, '', SEARCH"
    })
    void hiddenStatesKeepTheirPlaces(String all, String shown, String changed, String expected) {
        Scenario scenario = ScenarioTemplate.CORRIDOR.create();
        ScenarioProperties before = ScenarioProperties.of(scenario.withExpectation(states(false, shown)));
        ScenarioProperties after = ScenarioProperties.of(scenario.withExpectation(states(true, changed)));
        Scenario edited = after.applyChanges(before, scenario.withExpectation(states(false, all)));
        assertEquals(states(true, expected), edited.expectation());
        assertEquals(states(false, all), before.applyChanges(after, edited).expectation(), "undone");
    }

    private static Expectation states(boolean collides, String visited) {
        List<Expectation.Condition> conditions = new ArrayList<>(List.of(new Expectation.Collides(collides)));
        Stream.of(visited.split(" "))
                .filter(name -> !name.isEmpty())
                .map(FollowerState::valueOf)
                .map(Expectation.VisitedState::new)
                .forEach(conditions::add);
        conditions.add(new Expectation.FinalState(FollowerState.FOLLOW));
        return new Expectation(conditions);
    }

    private static void awaitRest(Workspace workspace) {
        Await.until(
                "the answers of the run",
                () -> !workspace.awaitsCommands() && workspace.task().isEmpty());
    }

    private static void await(Workspace workspace, ScenarioProperties wanted) {
        Await.until(
                "the properties",
                () -> workspace.task().isEmpty()
                        && workspace
                                .scenario()
                                .filter(open -> ScenarioProperties.of(open).equals(wanted))
                                .isPresent());
    }
}
