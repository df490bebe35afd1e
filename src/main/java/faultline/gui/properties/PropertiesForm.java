package faultline.gui.properties;

import faultline.engine.ControllerFactory;
import faultline.engine.SimulationSetup;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.FormDialog.FormProblem;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.TitledSection;
import faultline.gui.text.ContactText;
import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioLimits;
import faultline.world.Clearance;
import java.awt.GridBagLayout;
import java.util.Optional;
import java.util.OptionalLong;
import javax.swing.BoxLayout;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JTextField;

/** The fields of a scenario's properties. */
final class PropertiesForm extends JPanel {

    private static final int TEXT_COLUMNS = 25;
    private static final double MIN_SIZE = 0.5;
    private static final double MAX_SIZE = 1000;

    private final JTextField name = new JTextField(TEXT_COLUMNS);
    private final JTextField description = new JTextField(TEXT_COLUMNS);
    private final NumberSpinner width = new NumberSpinner("0.0##", MIN_SIZE, MAX_SIZE, 0.5, value -> {});
    private final NumberSpinner height = new NumberSpinner("0.0##", MIN_SIZE, MAX_SIZE, 0.5, value -> {});
    private final JCheckBox enclosed = new JCheckBox(Messages.get("properties.enclosed"));
    private final StartFields start = new StartFields(() -> {});
    private final NumberSpinner duration = new NumberSpinner("0.##", 0, ScenarioLimits.MAX_DURATION, 10, value -> {});
    private final NumberSpinner tick =
            new NumberSpinner("0.000##", ScenarioLimits.MIN_TICK, ScenarioLimits.MAX_TICK, 0.001, value -> {});
    private final JTextField seed = new JTextField(TEXT_COLUMNS / 2);
    private final ExpectationForm expectation = new ExpectationForm();

    PropertiesForm() {
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        JPanel fields = new JPanel(new GridBagLayout());
        FormConstraints.addRow(fields, 0, "properties.name", name);
        FormConstraints.addRow(fields, 1, "properties.description", description);
        FormConstraints.addRow(fields, 2, "properties.width", width.withColumns(8));
        FormConstraints.addRow(fields, 3, "properties.height", height.withColumns(8));
        fields.add(enclosed, FormConstraints.fillRow(1, 4));
        start.addTo(fields, 5);
        FormConstraints.addRow(fields, 6, "properties.duration", duration.withColumns(8));
        FormConstraints.addRow(fields, 7, "properties.tick", tick.withColumns(8));
        FormConstraints.addRow(fields, 8, "properties.seed", seed);
        add(new TitledSection(fields));
        add(new TitledSection("expect.title", expectation));
        NumberSpinner.findIn(this).forEach(NumberSpinner::keepInvalidText);
    }

    /** Returns the first field. */
    JTextField nameField() {
        return name;
    }

    /** Shows the properties of a scenario. */
    void setScenario(Scenario scenario) {
        ScenarioProperties shown = ScenarioProperties.of(scenario);
        name.setText(shown.name());
        description.setText(shown.description());
        description.setCaretPosition(0);
        width.setWorldValue(shown.width());
        height.setWorldValue(shown.height());
        enclosed.setSelected(shown.enclosed());
        start.setPose(shown.start());
        duration.setWorldValue(shown.duration());
        tick.setWorldValue(shown.dt());
        seed.setText(Long.toString(shown.seed()));
        expectation.setExpectation(shown.expectation(), ControllerFactory.statesInRun(scenario.setup()));
    }

    /** Returns the properties of the fields, in which {@link #findProblem} has found none. */
    ScenarioProperties properties() {
        return new ScenarioProperties(
                name.getText(),
                description.getText(),
                width.doubleValue(),
                height.doubleValue(),
                enclosed.isSelected(),
                start.pose(),
                duration.doubleValue(),
                tick.doubleValue(),
                typedSeed().orElseThrow(),
                expectation.expectation());
    }

    /** Commits what is being typed, and returns what is wrong with the fields for a scenario; empty if nothing is. */
    Optional<FormProblem> findProblem(Scenario scenario) {
        Optional<FormProblem> refused = FormDialog.describeRefusedNumber(this);
        if (refused.isPresent()) {
            return refused;
        }
        if (typedSeed().isEmpty()) {
            return Optional.of(new FormProblem(Messages.get("properties.seed.invalid"), seed));
        }
        return findObstruction(properties().applyTo(scenario))
                .map(sentence -> new FormProblem(sentence, start.firstField()));
    }

    /** Returns why the robot cannot start where a scenario places it; empty if it can. */
    static Optional<String> findObstruction(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        return Clearance.findObstruction(setup.world(), setup.robot(), setup.start())
                .map(obstacle -> ContactText.get("refused.start", obstacle));
    }

    private OptionalLong typedSeed() {
        return DecimalText.parseWhole(seed.getText());
    }
}
