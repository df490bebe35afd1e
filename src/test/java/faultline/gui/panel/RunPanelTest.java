package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.SampleFrames;
import faultline.engine.metrics.Expectation;
import faultline.engine.recording.Recording;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.theme.Theme;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Snapshot;
import java.awt.Component;
import java.awt.Rectangle;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The run panel without a display, with the frames of a run with a diagnosis. */
class RunPanelTest {

    private static final SessionStatus PAUSED = new SessionStatus(false, 1, 0, 0, null, null);

    private Scenario scenario;
    private RunPanel panel;

    @BeforeEach
    void open() throws ScenarioException {
        scenario = Scenario.loadShipped("left-sensor-stuck.xml");
        runOnEdt(() -> {
            Theme.LIGHT.install();
            panel = new RunPanel();
        });
    }

    private void show(double seconds) {
        show(scenario.setup().tickAt(seconds), PAUSED);
    }

    private void show(long tick, SessionStatus status) {
        try (Session session = Session.replay(new Journal(scenario.setup(), List.of(), tick), tick, reached -> true)) {
            SessionFrame frame = session.frame();
            // A number of calls, as the window makes them.
            runOnEdt(() -> {
                for (int i = 0; i < 10; i++) {
                    panel.setRun(frame, status, scenario);
                }
                panel.setSize(450, 600);
                ComponentFinder.layOut(panel);
            });
        }
    }

    private String value(String name) {
        return callOnEdt(() -> ComponentFinder.findValue(panel, name).getText());
    }

    @Test
    void theNumbersAreThoseOfTheFrame() {
        show(0);
        assertEquals("Search", value("State"));
        assertEquals("0.000 m/s", value("v"));
        assertEquals("–", value("Coverage"));
        show(20);
        assertTrue(value("v").matches("-?\\d\\.\\d{3} m/s"), value("v"));
        assertTrue(value("Time left").endsWith(" s"), value("Time left"));
        assertTrue(value("Strategy").startsWith("1 of 6"), value("Strategy"));
    }

    @Test
    void aVelocityThatIsZeroHasNoSign() {
        Snapshot world = SampleFrames.frameOf(Pose.ORIGIN).snapshot();
        Snapshot slow = new Snapshot(
                1,
                0.01,
                world.width(),
                world.height(),
                world.enclosed(),
                world.robot(),
                world.pose(),
                WheelSpeeds.of(new Velocity(-0.0004, -0.0004), world.robot().trueTrack()),
                world.motorFaults(),
                List.of(),
                List.of(),
                List.of(),
                List.of());
        Frame frame = new Frame(slow, Telemetry.ofState(FollowerState.FOLLOW), 0, 0, SampleFrames.pathThrough(), 0);
        runOnEdt(() -> panel.setRun(SampleSessionFrames.unmeasured(frame, Recording.EMPTY), PAUSED, scenario));
        assertEquals("0.000 m/s", value("v"));
        assertEquals("0.0 °/s", value("\u03c9"));
    }

    @Test
    void expectationsHaveTheUnitsOfTheNumbersAbove() throws ScenarioException {
        Scenario shipped = Scenario.loadShipped("left-sensor-stuck.xml");
        scenario = new Scenario(
                shipped.name(),
                shipped.description(),
                false,
                shipped.setup(),
                new Expectation(List.of(new Expectation.MinCoverage(0.285), new Expectation.MaxDistanceRms(0.0047))));
        show(20);
        assertTrue(value("Coverage").endsWith(" %") && value("RMS straight").endsWith(" mm"));
        assertEquals(value("Coverage"), value("Coverage at least 28.5 %"));
        assertEquals(value("RMS straight"), value("RMS at most 4.7 mm"));
    }

    @Test
    void aStuckSensorIsNamedWithItsReasonAndTheStrategyChanges() {
        double end = scenario.setup().duration();
        show(end);
        assertNotEquals("trusted", value("left: Finding"));
        assertTrue(value("left: Since").endsWith(" s"), value("left: Since"));
        assertEquals("trusted", value("rear: Finding"));
        assertTrue(!value("Strategy").startsWith("1 of 6"), value("Strategy"));
        assertEquals("none", value("Time left"));
    }

    @Test
    void aRunThatBeginsAgainShowsNoFindingOfTheOneBefore() {
        show(scenario.setup().duration());
        show(0);
        for (String column : List.of("Finding", "Evidence", "Since")) {
            assertEquals("–", value("left: " + column));
        }
    }

    @Test
    void nothingMovesWhileTheRunGoesOn() {
        show(0);
        List<Rectangle> before = places();
        show(25);
        assertEquals(before, places());
    }

    private List<Rectangle> places() {
        return callOnEdt(() -> ComponentFinder.tree(panel)
                .filter(part -> part instanceof JLabel)
                .map(Component::getBounds)
                .toList());
    }

    @Test
    void whatWasNotMetStaysFailedIfTheRunContinuesAfterItsEnd() {
        scenario = scenario.withExpectation(new Expectation(List.of(new Expectation.MinCoverage(1))));
        show(10);
        assertEquals("does not hold yet", coverageStatus());
        show(scenario.setup().duration());
        assertEquals("does not hold", coverageStatus());
        show(scenario.setup().ticks() + 1, new SessionStatus(true, 1, 1, 0, null, null));
        assertEquals("does not hold", coverageStatus());
    }

    /** 30 ticks of 0.03 s are 0.8999999999999999 s if they are multiplied. */
    @Test
    void theLastTickIsTheEndWhereverItsTimeIsRounded() {
        scenario = scenario.withExpectation(new Expectation(List.of(new Expectation.MinCoverage(1))))
                .withSetup(scenario.setup().withTick(0.03).withDuration(0.9));
        show(29, PAUSED);
        assertEquals("0.0 s", value("Time left"));
        assertEquals("does not hold yet", coverageStatus());
        show(30, PAUSED);
        assertEquals("none", value("Time left"));
        assertEquals("does not hold", coverageStatus());
    }

    private String coverageStatus() {
        return callOnEdt(() -> ComponentFinder.findAll(panel, JLabel.class)
                .filter(label -> label.getText().startsWith("Coverage at least"))
                .map(JLabel::getToolTipText)
                .findFirst()
                .orElseThrow());
    }
}
