package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.ladder.Rung;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.TitledSection;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.ExpectationText;
import faultline.gui.text.HealthText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.text.StateText;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.robot.Velocity;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.BoxLayout;
import javax.swing.JLabel;
import javax.swing.JPanel;

/**
 * The results of a run so far: state, velocity, measures, remaining time, the scenario's expectations, and the
 * diagnosis of the sensors. Numbers come from frames and are updated about ten times per second.
 */
public final class RunPanel extends JPanel {

    private static final int FRAMES_PER_UPDATE = 6;
    private static final int COLUMN_GAP = 18;

    private final JPanel numbers = new JPanel(new WrappingGridLayout());
    private final ValueLabel state = addValue("run.state", 0, 0, () -> Stream.of(FollowerState.values())
            .map(StateText::name)
            .toList());
    private final ValueLabel timeLeft = addValue("run.timeLeft", 2, 0, "00000.0 s");
    private final ValueLabel linear = addValue("run.linear", 0, 1, "-0.000 m/s");
    private final ValueLabel angular = addValue("run.angular", 2, 1, "-0000.0 °/s");
    private final ValueLabel coverage = addValue("run.coverage", 0, 2, "100.0 %");
    private final ValueLabel laps = addValue("run.laps", 2, 2, "00000.00");
    private final ValueLabel straightRms = addValue("run.straightRms", 0, 3, "0000.0 mm");
    private final ValueLabel followRms = addValue("run.followRms", 2, 3, "0000.0 mm");
    private final ValueLabel rung = addValue(
            "run.rung", FormConstraints.cell(0, 4), FormConstraints.fillRow(1, 4), () -> Stream.of(Rung.values())
                    .map(value -> rungText(value.name()))
                    .toList());
    private final ExpectationRows expectations = new ExpectationRows();
    private final HealthRows health = new HealthRows();
    private transient SessionFrame shown;
    private boolean wasRunning;
    private int skippedFrames;

    /** Creates a panel without a run. */
    RunPanel() {
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        add(new TitledSection(numbers));
        add(new TitledSection("expect.title", expectations));
        add(new TitledSection("health.title", health));
        // The next update shows all texts again.
        RefreshSteps.add(this, panel -> panel.shown = null);
    }

    private ValueLabel addValue(String key, int column, int row, String widest) {
        return addValue(key, column, row, () -> List.of(widest));
    }

    private ValueLabel addValue(String key, int column, int row, Supplier<List<String>> widest) {
        GridBagConstraints labelCell = FormConstraints.cell(column, row);
        labelCell.insets.left += column == 0 ? 0 : COLUMN_GAP;
        return addValue(key, labelCell, FormConstraints.fillCell(column + 1, row), widest);
    }

    private ValueLabel addValue(
            String key, GridBagConstraints labelCell, GridBagConstraints valueCell, Supplier<List<String>> widest) {
        ValueLabel value = new ValueLabel(() -> Messages.get(key), widest);
        JLabel label = FormConstraints.label(key, value);
        UiText.tip(label, key + ".tip");
        numbers.add(label, labelCell);
        numbers.add(value, valueCell);
        return value;
    }

    /**
     * Shows a run of a scenario with ticks of the same length; numbers that change with every frame wait for the next
     * update.
     */
    void setRun(SessionFrame frame, SessionStatus status, Scenario scenario) {
        assert EventQueue.isDispatchThread();
        boolean stopped = wasRunning && !status.running();
        if (++skippedFrames >= FRAMES_PER_UPDATE || shown == null || stopped) {
            wasRunning = status.running();
            skippedFrames = 0;
            update(frame, scenario);
        }
    }

    private void update(SessionFrame frame, Scenario scenario) {
        if (frame != shown) {
            shown = frame;
            updateNumbers(frame);
            health.setHealth(
                    diagnosedSensors(scenario.setup()),
                    frame.telemetry().diagnosis().health(),
                    scenario.setup().dt());
        }
        SimulationSetup setup = scenario.setup();
        long tick = frame.snapshot().tick();
        boolean ended = tick >= setup.ticks();
        timeLeft.setValue(
                ended
                        ? Messages.get("run.noTimeLeft")
                        : NumberText.formatOrDash("%.1f s", setup.duration() - setup.timeOf(tick)));
        expectations.setFacts(scenario.expectation().conditions(), frame, ended);
    }

    private static List<String> diagnosedSensors(SimulationSetup setup) {
        return setup.controller() instanceof ControllerSpec.WallFollowing follower && follower.diagnosis()
                ? setup.robot().sensorIds()
                : List.of();
    }

    private void updateNumbers(SessionFrame frame) {
        Velocity velocity = frame.snapshot().velocity();
        RunMeasures measures = frame.measures();
        state.setValue(StateText.name(frame.telemetry().state()));
        linear.setValue(NumberText.format("%.3f m/s", velocity.linear()));
        angular.setValue(NumberText.format("%.1f °/s", Math.toDegrees(velocity.angular())));
        coverage.setValue(ExpectationText.percent(measures.coverage()));
        laps.setValue(NumberText.formatOrDash("%.2f", measures.laps()));
        straightRms.setValue(ExpectationText.millimetres(measures.distanceRms()));
        followRms.setValue(ExpectationText.millimetres(measures.followRms()));
        rung.setValue(rungText(frame.telemetry().diagnosis().rung()));
    }

    private static String rungText(String rung) {
        return rung.isEmpty() ? "–" : HealthText.rungPosition(rung);
    }
}
