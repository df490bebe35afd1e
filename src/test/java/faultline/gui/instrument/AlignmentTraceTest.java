package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.Font;
import java.awt.FontMetrics;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The turn timing shows the values of the controller and of the run. */
class AlignmentTraceTest {

    private static final SessionFrame FRAME = SampleRuns.frame(2000);

    /** Returns the tick of the newest transition to a state. */
    private static long arrival(SessionFrame frame, FollowerState state) {
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= 0; i--) {
            if (log.get(i) instanceof RunEvent.StateChanged transition && transition.to() == state) {
                return transition.tick();
            }
        }
        throw new AssertionError("the run never came to " + state);
    }

    /** The longest values are headings of three digits behind a sign. */
    @ParameterizedTest
    @EnumSource(Language.class)
    void namesDoNotOverlapTheirValues(Language language) {
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
        runOnEdt(() -> {
            Messages.setLanguage(language);
            try {
                FontMetrics metrics = new JLabel().getFontMetrics(font);
                for (TimingRule rule : TimingRule.values()) {
                    AlignmentTrace spin =
                            new AlignmentTrace(List.of(), -1.85, -1.05, -3.1, 10000.5, 10001.7, 0.6, 0, -3.1, rule);
                    for (AlignmentText.NamedValue row : AlignmentText.rows(spin)) {
                        String widest = row.value().endsWith("°") ? "\u2212178.00°" : row.value();
                        int width = metrics.stringWidth(row.name() + " " + widest);
                        assertTrue(width <= AlignmentView.VALUE_END, row + ": " + width + " pixels");
                    }
                }
            } finally {
                Messages.setLanguage(Language.ENGLISH);
            }
        });
    }

    @Test
    void beforeTheFirstTurnThereIsNone() {
        assertEquals(Optional.empty(), AlignmentTrace.latest(SampleRuns.frame(10)));
    }

    @Test
    void timesAreTheControllersAndTpIsHalfOfTd() {
        AlignmentTrace spin = AlignmentTrace.latest(FRAME).orElseThrow();
        assertEquals(FRAME.telemetry().edges().tF3(), spin.f3());
        assertEquals(FRAME.telemetry().edges().tF4(), spin.f4());
        assertEquals(spin.tD() / 2, spin.tP(), 1e-12);
    }

    @ParameterizedTest
    @EnumSource(WallSide.class)
    void theAchievedHeadingIsThatOfTheHandOverAndCloseToThePredictedOne(WallSide hand) {
        SimulationSetup setup = SampleRuns.setup(ControllerSpec.WallFollowing.DEFAULT.withSide(hand));
        SessionFrame frame = SampleRuns.frame(setup, 2000);
        AlignmentTrace spin = AlignmentTrace.latest(frame).orElseThrow();
        assertEquals(hand, spin.wallSide());
        double handOver = SampleRuns.frame(setup, arrival(frame, FollowerState.ALIGN) + 1)
                .snapshot()
                .pose()
                .heading();
        assertTrue(Math.abs(handOver - spin.achievedHeading()) > 0.01, "the turn back is not over when ALIGN begins");
        double atFollow = SampleRuns.frame(setup, arrival(frame, FollowerState.FOLLOW) - 1)
                .snapshot()
                .pose()
                .heading();
        assertEquals(atFollow, spin.achievedHeading(), 1e-5);
        assertEquals(0, Math.toDegrees(spin.headingError().orElseThrow()), 0.5);
        assertEquals(
                0,
                Math.toDegrees(Math.IEEEremainder(spin.achievedHeading(), Math.PI / 2)),
                1.0,
                "along a wall of the room");
    }

    @Test
    void theErrorIsThatOfTheTurnHoweverOftenTheRobotHasTurnedBefore() {
        SimulationSetup setup = SampleRuns.ROOM_SETUP;
        Pose start = setup.start();
        Pose turned = new Pose(start.x(), start.y(), start.heading() + 2 * StrictMath.PI * 100_000);
        AlignmentTrace first =
                AlignmentTrace.latest(SampleRuns.frame(setup, 2000)).orElseThrow();
        AlignmentTrace later = AlignmentTrace.latest(SampleRuns.frame(setup.withStart(turned), 2000))
                .orElseThrow();
        assertEquals(first.headingError().orElseThrow(), later.headingError().orElseThrow(), 1e-6);
        assertEquals(first.origin(), later.origin(), 1e-6);
    }

    @Test
    void withMotorsTooSlowForTheTurnRateTheHeadingErrorIsThatOfTheTurn() {
        RobotSpec slow = SampleRuns.ROOM_SETUP
                .robot()
                .withMotor(new MotorSpec(0.05, 0.1, 3.2))
                .withTurnRate(StrictMath.toRadians(400));
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withRobot(slow);
        AlignmentTrace trace =
                AlignmentTrace.latest(SampleRuns.frame(setup, 2000)).orElseThrow();
        assertEquals(0, Math.toDegrees(trace.headingError().orElseThrow()), 0.5);
    }

    @Test
    void theReadingsFallToTheWallAndRiseAgainAroundTheMiddleOfTd() {
        AlignmentTrace spin = AlignmentTrace.latest(FRAME).orElseThrow();
        AlignmentTrace.AlignmentSample nearest = spin.samples().stream()
                .filter(sample -> sample.clock() >= spin.f3())
                .min((one, other) -> Double.compare(one.reading(), other.reading()))
                .orElseThrow();
        assertEquals((spin.f3() + spin.f4()) / 2, nearest.clock(), spin.tD() / 4);
        double last = spin.samples().get(spin.samples().size() - 1).reading();
        assertTrue(last > nearest.reading() + 0.01, last + " after " + nearest.reading());
        assertEquals(spin.clockAt(spin.predictedHeading()), (spin.f3() + spin.f4()) / 2, 1e-9);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.7, 1.4})
    void theCurveIsOnTheClockOfTheControllerIfTheRobotTurnsAtAnotherRate(double trackScale) {
        RobotSpec robot = SampleRuns.ROOM_SETUP.robot().withDriveScale(new DriveScale(1, 1, trackScale));
        SimulationSetup setup = SampleRuns.setup(ControllerSpec.WallFollowing.DEFAULT.withDiagnosis(false))
                .withRobot(robot);
        SessionFrame frame = SampleRuns.frame(setup, arrival(SampleRuns.frame(setup, 2000), FollowerState.ALIGN) + 5);
        AlignmentTrace spin = AlignmentTrace.latest(frame).orElseThrow();
        double newest = spin.samples().get(spin.samples().size() - 1).clock();
        assertEquals(spin.f4(), newest, 3 * frame.dt(), "F4 is just before ALIGN");
        assertEquals(frame.snapshot().robot().spinRate() / trackScale, -spin.rate(), 1e-3);
        assertEquals(spin.origin() + spin.f4(), lastTiming(frame).f4(), 1e-9);
    }

    @Test
    void inTheMiddleOfATurnWhatIsNotKnownYetIsADash() {
        long turn = arrival(FRAME, FollowerState.TURN);
        AlignmentView instrument = callOnEdt(AlignmentView::new);
        runOnEdt(() -> instrument.setFrame(SampleRuns.frame(turn + 5)));
        List<String> values = callOnEdt(() ->
                instrument.rows().stream().map(AlignmentText.NamedValue::value).toList());
        assertEquals(List.of("equal readings", "–", "–", "–", "–", "–", "–", "–"), values);
        runOnEdt(() -> SampleRuns.render(instrument, 900, 200));
    }

    @Test
    void theEventLogHasTheSameF3AndF4() {
        EventLog log = FRAME.recording().events();
        RunEvent.AlignmentTimed timed = LongStream.range(log.firstIndex(), log.endIndex())
                .mapToObj(log::get)
                .filter(RunEvent.AlignmentTimed.class::isInstance)
                .map(RunEvent.AlignmentTimed.class::cast)
                .reduce((first, second) -> second)
                .orElseThrow();
        AlignmentTrace trace = AlignmentTrace.latest(FRAME).orElseThrow();
        assertEquals(trace.origin() + trace.f3(), timed.f3(), 1e-5);
        assertEquals(trace.origin() + trace.f4(), timed.f4(), 1e-5);
        // eq. (4): t_p = t_D / 2
        assertEquals((timed.f4() - timed.f3()) / 2, timed.edges().tP(), 1e-9);
        assertTrue(timed.f3() < timed.f4() && timed.f4() <= timed.time());
    }

    /** A controller in Java with a strategy that the ladder of the program does not have. */
    private static Controller limping() {
        return observation -> new Decision(
                1,
                1,
                new Telemetry(
                        FollowerState.SEARCH,
                        "",
                        0,
                        0,
                        Telemetry.WallControl.NONE,
                        Telemetry.EdgeTimes.NONE,
                        new Telemetry.Diagnosis("LIMP", List.of())));
    }

    @Test
    void aStrategyOfAnotherControllerIsNotOfTheLadder() {
        ControllerSource source = new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                return limping();
            }

            @Override
            public boolean limitsAnswerTime() {
                return false;
            }
        };
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withController(
                new ControllerSpec.Chosen(SampleRuns.ROOM_SETUP.controller(), source));
        assertEquals(Optional.empty(), AlignmentTrace.latest(SampleRuns.frame(setup, 10)));
    }

    @Test
    void theTimesStayWhenAnotherStrategyDrives() {
        double end = 20;
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withTimeline(
                List.of(new SimulationSetup.TimedCommand(end, new Command.InjectFault("left", new Fault.Stuck(0.6)))));
        SessionFrame before = SampleRuns.frame(setup, 1990);
        RunEvent.AlignmentTimed timed = lastTiming(before);
        long tick = 2000;
        SessionFrame frame = before;
        while (!Double.isNaN(frame.telemetry().edges().tP()) && tick < 2600) {
            tick += 20;
            frame = SampleRuns.frame(setup, tick);
        }
        assertTrue(Double.isNaN(frame.telemetry().edges().tP()), "another strategy drives");
        AlignmentTrace trace = AlignmentTrace.latest(frame).orElseThrow();
        assertEquals(timed, lastTiming(frame), "no other turn");
        assertEquals(timed.f3(), trace.origin() + trace.f3(), 1e-9);
        assertEquals(timed.f4(), trace.origin() + trace.f4(), 1e-9);
        assertEquals(timed.edges().tP(), trace.tP());
    }

    @Test
    void aTurnThatASensorFailureInterruptsEndsThere() {
        long turn = arrival(FRAME, FollowerState.TURN);
        double failure = (turn + 20) * SampleRuns.ROOM_SETUP.dt();
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withTimeline(
                List.of(new SimulationSetup.TimedCommand(failure, new Command.SwitchSensor("left", false))));
        AlignmentTrace soon =
                AlignmentTrace.latest(SampleRuns.frame(setup, turn + 30)).orElseThrow();
        AlignmentTrace late =
                AlignmentTrace.latest(SampleRuns.frame(setup, turn + 400)).orElseThrow();
        assertTrue(soon.samples().size() < 30, soon.samples().size() + " samples");
        assertEquals(soon.samples(), late.samples());
        assertEquals(soon.headingNow(), late.headingNow());
        assertTrue(Double.isNaN(late.achievedHeading()), "the manoeuvre did not lead to FOLLOW");
        assertTrue(!late.isTimed());
    }

    @Test
    void theRuleIsTheOneThatDeterminedTheTimes() {
        ControllerSpec.WallFollowing range = ControllerSpec.WallFollowing.DEFAULT.withTimingRule(TimingRule.RANGE);
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withTimeline(
                List.of(new SimulationSetup.TimedCommand(20, new Command.ConfigureController(range))));
        long turn = arrival(FRAME, FollowerState.TURN);
        SessionFrame changed = SampleRuns.frame(setup, 2010);
        assertEquals(range, changed.controller());
        assertTrue(turn < 2000 && arrival(changed, FollowerState.TURN) == turn, "no other turn");
        AlignmentTrace trace = AlignmentTrace.latest(changed).orElseThrow();
        assertEquals(TimingRule.EQUAL_READINGS, trace.rule());
        assertEquals(lastTiming(changed).rule(), trace.rule());
        AlignmentView view = callOnEdt(AlignmentView::new);
        runOnEdt(() -> view.setFrame(changed));
        assertEquals("equal readings", callOnEdt(() -> view.rows().get(0).value()));
        SimulationSetup other = SampleRuns.ROOM_SETUP.withController(range);
        assertEquals(
                TimingRule.RANGE,
                AlignmentTrace.latest(SampleRuns.frame(other, 2000))
                        .orElseThrow()
                        .rule());
    }

    private static RunEvent.AlignmentTimed lastTiming(SessionFrame frame) {
        EventLog log = frame.recording().events();
        return LongStream.range(log.firstIndex(), log.endIndex())
                .mapToObj(log::get)
                .filter(RunEvent.AlignmentTimed.class::isInstance)
                .map(RunEvent.AlignmentTimed.class::cast)
                .reduce((first, second) -> second)
                .orElseThrow();
    }

    @Test
    void allNumbersAreSaidForReadersOfTheScreen() {
        AlignmentView instrument = callOnEdt(AlignmentView::new);
        runOnEdt(() -> instrument.setFrame(FRAME));
        String words = callOnEdt(() -> instrument.getAccessibleContext().getAccessibleDescription());
        assertTrue(
                words.matches("timing rule equal readings, F3 \\d+\\.\\d{3} s, F4 \\d+\\.\\d{3} s, t_D \\d\\.\\d{3} "
                        + "s, t_p \\d\\.\\d{4} s, predicted heading .+°, actual heading "
                        + ".+°, error [+\u2212]0\\.\\d\\d°"),
                words);
        runOnEdt(() -> SampleRuns.render(instrument, 900, 200));
    }

    /** A paused run sends no more frames. */
    @Test
    void theWordsForReadersOfTheScreenFollowTheLanguage() {
        runOnEdt(() -> {
            AlignmentView instrument = new AlignmentView();
            instrument.setFrame(FRAME);
            try {
                Messages.setLanguage(Language.POLISH);
                RefreshSteps.run(instrument);
                String first = instrument.rows().get(0).name();
                String words = instrument.getAccessibleContext().getAccessibleDescription();
                assertNotEquals("timing rule", first);
                assertTrue(words.startsWith(first), words);
            } finally {
                Messages.setLanguage(Language.ENGLISH);
            }
        });
    }
}
