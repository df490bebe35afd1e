package faultline.gui.bar;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.RunProblem;
import faultline.engine.SampleFrames;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.recording.Recording;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.paint.surface.Camera;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Refusal;
import faultline.world.Snapshot;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class StatusBarTest {

    private static final String FAILURE = "the controller does not answer";
    private static final SessionStatus FAILED = new SessionStatus(false, 1, 0, 0, null, RunProblem.OTHER.with(FAILURE));

    private final AtomicLong nanos = new AtomicLong();
    private final StatusBar bar = callOnEdt(() -> new StatusBar(nanos::get));

    @Test
    void aRunIsSummarisedInOneLine() {
        show(SampleFrames.frameOf(new Pose(1.5, 2, Degrees.toRadians(-90))), running(0.98));
        assertEquals(
                List.of("Running", "t 0.010 s", "0.98× real time", "Follow", "x 1.500  y 2.000  θ -90.0°"),
                texts().subList(0, 5));
    }

    /** The cell of the time is as wide for all of them, so that the others do not move. */
    @Test
    void timesTellTheTicksOfTheRunApart() {
        runOnEdt(() -> {
            bar.setFrame(frame(1, 0.01), running(1));
            int usual = timeCell().getPreferredSize().width;
            bar.setFrame(frame(1, 1e-5), running(1));
            assertEquals("t 0.00001 s", timeCell().getText());
            int wide = timeCell().getPreferredSize().width;
            bar.setFrame(frame(8_888_888_888L, 1e-5), running(1));
            assertEquals("t 88888.88888 s", timeCell().getText());
            assertEquals(wide, timeCell().getPreferredSize().width);
            bar.setFrame(frame(8_888_888, 0.01), running(1));
            assertEquals("t 88888.880 s", timeCell().getText());
            assertEquals(usual, timeCell().getPreferredSize().width);
        });
    }

    private StatusCell timeCell() {
        return ComponentFinder.find(bar, StatusCell.class, Messages.get("status.time"));
    }

    private static SessionFrame frame(long tick, double dt) {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        Snapshot world = frame.snapshot();
        Snapshot later = new Snapshot(
                tick,
                tick * dt,
                world.width(),
                world.height(),
                true,
                world.robot(),
                world.pose(),
                world.wheelSpeeds(),
                world.motorFaults(),
                List.of(),
                List.of(),
                List.of(),
                List.of());
        Frame at = new Frame(later, frame.telemetry(), 0, 0, frame.path(), 0);
        return new SessionFrame(at, Recording.EMPTY, RunMeasures.NONE, new ControllerSpec.None(), "", dt);
    }

    @Test
    void onlyANoteThatIsRemovedByTheBarItselfIsReported() {
        AtomicInteger reported = new AtomicInteger();
        runOnEdt(() -> {
            bar.setNoteListener(reported::incrementAndGet);
            bar.keepNote("until it is removed");
            bar.removeNote("until it is removed");
            assertEquals(0, reported.get());
            bar.showNote("until it is read");
            assertEquals(1, reported.get());
            bar.showLine("a line of a program");
            assertEquals(2, reported.get());
            bar.keepNote("for as long as it holds", () -> true);
            assertEquals(3, reported.get());
        });
    }

    @Test
    void theTickIsInTheLanguageOfTheWindow() {
        runOnEdt(() -> Messages.setLanguage(Language.POLISH));
        try {
            show(SampleFrames.frameOf(new Pose(1, 1, 0)), running(1));
            assertTrue(texts().contains("krok 1"), texts().toString());
        } finally {
            runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
        }
    }

    @Test
    void aHeadingIsShownWithinHalfATurnAndNeverAsMinusZero() {
        show(SampleFrames.frameOf(new Pose(1, 1, 7 * Math.PI - 1e-3)), running(1));
        assertTrue(texts().get(4).endsWith("θ 179.9°"), texts().get(4));
        show(SampleFrames.frameOf(new Pose(1, 1, -1e-4)), running(1));
        assertTrue(texts().get(4).endsWith("θ 0.0°"), texts().get(4));
    }

    @Test
    void aRunWhoseControllerDoesNotAnswerSaysSo() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        show(frame, running(2.0));
        show(1900, frame, running(2.0));
        assertTrue(texts().contains("2.00× real time"));
        show(2100, frame, running(2.0));
        assertTrue(texts().contains("Waiting for an answer from the controller"));
        assertFalse(texts().contains("2.00× real time"));
        show(frame, new SessionStatus(false, 1, 0, 0, null, null));
        assertFalse(texts().contains("Waiting for an answer from the controller"));
    }

    @Test
    void aRunThatDoesNotPauseAtOnceSaysThatItWaits() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        SessionStatus paused = new SessionStatus(false, 1, 0, 0, null, null);
        String waiting = "Waiting for an answer from the controller";
        show(frame, running(2.0));
        runOnEdt(bar::pauseRequested);
        show(90, frame, running(2.0));
        assertFalse(texts().contains(waiting), "it may pause in this moment");
        runOnEdt(bar::pauseRequested);
        show(110, frame, running(2.0));
        assertTrue(texts().contains(waiting));
        show(frame, paused);
        assertFalse(texts().contains(waiting));
        show(frame, running(2.0));
        show(320, frame, running(2.0));
        assertFalse(texts().contains(waiting), "resumed");
        runOnEdt(bar::pauseRequested);
        runOnEdt(bar::reset);
        show(600, frame, running(2.0));
        assertFalse(texts().contains(waiting), "another run");
    }

    @Test
    void aRunThatWasResumedBeforeItsPauseWasSeenDoesNotWait() {
        show(SampleFrames.frameOf(new Pose(1, 1, 0)), running(2.0));
        runOnEdt(bar::pauseRequested);
        for (int tick = 1; tick < 30; tick++) {
            show(20 * tick, frameAtTick(tick), running(2.0));
            assertFalse(texts().contains("Waiting for an answer from the controller"), "tick " + tick);
        }
        show(800, frameAtTick(29), running(2.0));
        assertFalse(texts().contains("Waiting for an answer from the controller"), "a slow tick later");
    }

    private static Frame frameAtTick(long tick) {
        Snapshot other = SampleFrames.frameOf(new Pose(1, 1, 0)).snapshot();
        Snapshot snapshot = new Snapshot(
                tick,
                tick * 0.01,
                other.width(),
                other.height(),
                other.enclosed(),
                other.robot(),
                other.pose(),
                other.wheelSpeeds(),
                other.motorFaults(),
                other.sensors(),
                other.obstacles(),
                other.contacts(),
                other.collisions());
        return new Frame(snapshot, Telemetry.ofState(FollowerState.SEARCH), 0, 0, SampleFrames.pathThrough(), 0);
    }

    /** Two ticks of 10 ms take 5 s at this speed. */
    @Test
    void atALowSpeedTheFirstAnswerMayTakeTwoTicks() {
        SessionStatus slow = new SessionStatus(true, 0.004, 0, 0, null, null);
        Frame frame = frameAtTick(0);
        show(frame, slow);
        show(4900, frame, slow);
        assertFalse(texts().contains("Waiting for an answer from the controller"));
        show(5100, frame, slow);
        assertTrue(texts().contains("Waiting for an answer from the controller"));
    }

    @Test
    void theCursorPositionIsShownWhileTheMouseIsOnTheCanvas() {
        runOnEdt(() -> bar.showCursor(new Vector2(1.234, -2)));
        assertEquals("cursor 1.23, -2.00", texts().get(5));
        runOnEdt(() -> bar.showCursor(null));
        assertEquals("", texts().get(5));
    }

    @Test
    void theScaleOfALargeWorldIsNotRoundedToZero() {
        runOnEdt(() -> bar.showScale(64.6));
        assertEquals("65 px/m", texts().get(6));
        runOnEdt(() -> bar.showScale(Camera.MIN_SCALE));
        assertEquals("0.005 px/m", texts().get(6));
    }

    @Test
    void aRefusalIsShownForSomeTime() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        SessionStatus refused =
                new SessionStatus(false, 1, 1, 1, new Refusal(Refusal.Reason.UNKNOWN_OBSTACLE, "box"), null);
        show(frame, refused);
        assertTrue(texts().contains("there is no obstacle box"));
        show(4900, frame, refused);
        assertTrue(texts().contains("there is no obstacle box"), "however often it was painted");
        show(5100, frame, refused);
        assertFalse(texts().contains("there is no obstacle box"));
    }

    @Test
    void theRefusalOfAPlaceIsShownUntilTheObstacleHasGotAnotherOne() {
        Obstacle box = new Obstacle("box", new ObstacleShape.CircleShape(0.1), new Pose(2, 2, 0));
        Frame before = SampleFrames.frameOf(new Pose(1, 1, 0), box);
        SessionStatus refused =
                new SessionStatus(false, 1, 1, 1, new Refusal(Refusal.Reason.OVERLAPS_ROBOT, "box"), null);
        String sentence = "box cannot be put there: it would overlap the robot";
        show(before, refused);
        show(1500, before, refused);
        assertTrue(texts().contains(sentence));
        show(1600, SampleFrames.frameOf(new Pose(1, 1, 0), box.withPose(new Pose(2, 3, 0))), refused);
        assertFalse(texts().contains(sentence));
    }

    @Test
    void aLongNoteIsShownLonger() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        String sentence = "word ".repeat(30);
        runOnEdt(() -> bar.showNote(sentence));
        show(11_900, frame, running(1));
        assertTrue(texts().contains(sentence));
        show(12_100, frame, running(1));
        assertFalse(texts().contains(sentence));
    }

    @Test
    void onlyTheNoteThatIsNoLongerTrueIsRemoved() {
        runOnEdt(() -> bar.showNote("old"));
        runOnEdt(() -> bar.removeNote("other"));
        assertTrue(texts().contains("old"));
        runOnEdt(() -> bar.removeNote("old"));
        assertFalse(texts().contains("old"));
    }

    @Test
    void aKeptNoteStaysAsLongAsItHoldsAndReturnsAfterAnother() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        AtomicBoolean holds = new AtomicBoolean(true);
        runOnEdt(() -> bar.keepNote("not kept", holds::get));
        show(1_000_000, frame, running(1));
        assertTrue(texts().contains("not kept"));
        assertFalse(callOnEdt(bar::isNoteShown), "nothing has to be polled");
        holds.set(false);
        show(2000, frame, running(1));
        assertFalse(texts().contains("not kept"));
        holds.set(true);
        runOnEdt(() -> bar.keepNote("not kept", holds::get));
        runOnEdt(() -> bar.showNote("saved"));
        assertFalse(texts().contains("not kept"));
        show(8000, frame, running(1));
        assertTrue(texts().contains("not kept"));
    }

    @Test
    void aKeptNoteIsShownInPlaceOfTheReasonOfAFailureAndOfPrintedLines() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        show(frame, FAILED);
        runOnEdt(() -> bar.keepNote("changed", () -> true));
        show(60_000, frame, FAILED);
        assertTrue(texts().contains("changed"));
        assertFalse(texts().contains(FAILURE));
        runOnEdt(() -> bar.showLine("tick 1"));
        assertTrue(texts().contains("changed"));
        runOnEdt(() -> bar.removeNote("changed"));
        assertTrue(texts().contains(FAILURE));
    }

    @Test
    void aNoteIsReadBeforeTheReasonOfAFailureReturns() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        show(frame, FAILED);
        runOnEdt(() -> bar.showNote("saved"));
        show(4900, frame, FAILED);
        assertTrue(texts().contains("saved"));
        assertTrue(callOnEdt(bar::isNoteShown));
        show(5100, frame, FAILED);
        assertTrue(texts().contains(FAILURE));
        assertFalse(callOnEdt(bar::isNoteShown), "nothing has to be polled");
    }

    @Test
    void aPrintedLineIsShownForSomeTimeAndDoesNotHideANote() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        runOnEdt(() -> bar.showLine("tick 1"));
        assertTrue(texts().contains("tick 1"));
        runOnEdt(() -> bar.showNote("saved"));
        runOnEdt(() -> bar.showLine("tick 2"));
        assertTrue(texts().contains("saved"));
        show(5100, frame, running(1));
        assertFalse(texts().contains("saved"));
        runOnEdt(() -> bar.showLine("tick 3"));
        assertTrue(texts().contains("tick 3"));
        show(10_300, frame, running(1));
        assertFalse(texts().contains("tick 3"));
    }

    @Test
    void aNoteThatNoLongerHoldsIsRemovedWhenItCanHaveBeenRead() {
        Frame there = SampleFrames.frameOf(new Pose(1, 1, 0));
        Frame elsewhere = SampleFrames.frameOf(new Pose(2, 1, 0));
        runOnEdt(() -> bar.showNote(
                "no room", world -> world.pose().equals(there.snapshot().pose())));
        show(1700, there, running(1));
        assertTrue(texts().contains("no room"));
        show(elsewhere, running(1));
        assertFalse(texts().contains("no room"));
        runOnEdt(() -> bar.showNote("no room", world -> false));
        show(elsewhere, running(1));
        assertTrue(texts().contains("no room"), "at once it could not be read");
        runOnEdt(() -> bar.showNote("another note"));
        show(3400, elsewhere, running(1));
        assertTrue(texts().contains("another note"));
    }

    @Test
    void theReasonOfAFailedRunStays() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        show(frame, FAILED);
        show(60_000, frame, FAILED);
        assertEquals("Failed", texts().get(0));
        assertTrue(texts().contains(FAILURE));
    }

    @Test
    void theReasonOfAFailureGoesWithTheFailedRun() {
        Frame frame = SampleFrames.frameOf(new Pose(1, 1, 0));
        show(frame, FAILED);
        show(frame, new SessionStatus(false, 1, 0, 0, null, null));
        assertEquals("Paused", texts().get(0));
        assertFalse(texts().contains(FAILURE));
        assertFalse(callOnEdt(bar::isNoteShown));
    }

    @Test
    void aRefusalHidesTheLastCellsOfANarrowStatusBar() {
        runOnEdt(() -> bar.setSize(2000, 28));
        assertEquals(8, shown());
        runOnEdt(() -> bar.setSize(600, 28));
        assertEquals(4, shown());
        runOnEdt(() -> bar.showNote("box cannot be put there: it would overlap the robot"));
        assertEquals(2, shown());
    }

    /** A note about a ghost in the making with a name of the greatest length, in a small window. */
    @Test
    void theStateAndThePoseOfTheRunAreShownBesideTheProgressOfAGhost() {
        for (Language language : Language.values()) {
            runOnEdt(() -> {
                Messages.setLanguage(language);
                bar.setSize(1020, 28);
                RefreshSteps.run(bar);
                bar.showNote(Messages.get("ghost.progress", "99", "a_follower.py…"));
            });
            long cells = shown();
            runOnEdt(() -> Messages.setLanguage(Language.ENGLISH));
            assertTrue(cells >= 5, language + ": " + cells);
        }
    }

    @Test
    void aCellGrowsForATextThatIsLongerThanUsual() {
        runOnEdt(() -> {
            StatusCell cell = new StatusCell("status.time", () -> Stream.of("t 0.000 s"));
            cell.setStatusText("t 1576110.610 s");
            int text = cell.getFontMetrics(cell.getFont()).stringWidth(cell.getText());
            assertTrue(cell.getPreferredSize().width >= text, "clips its text");
        });
    }

    @Test
    void aCellStillShowsItsTextAfterANewTextSize() {
        runOnEdt(() -> {
            StatusCell cell = new StatusCell("status.state", () -> Stream.of("Follow"));
            cell.setStatusText("Stopped at a wall that nobody expected");
            cell.setFont(cell.getFont().deriveFont(30f));
            RefreshSteps.run(cell);
            int text = cell.getFontMetrics(cell.getFont()).stringWidth(cell.getText());
            assertTrue(cell.getPreferredSize().width >= text, "clips its text");
        });
    }

    private long shown() {
        return callOnEdt(() -> {
            bar.doLayout();
            return ComponentFinder.findAll(bar, StatusCell.class)
                    .filter(StatusCell::isVisible)
                    .count();
        });
    }

    private static SessionStatus running(double achieved) {
        return new SessionStatus(true, 1, achieved, 0, null, null);
    }

    private void show(Frame frame, SessionStatus status) {
        runOnEdt(() -> bar.setFrame(SampleSessionFrames.unmeasured(frame, Recording.EMPTY), status));
    }

    private void show(long atMillis, Frame frame, SessionStatus status) {
        nanos.set(TimeUnit.MILLISECONDS.toNanos(atMillis));
        show(frame, status);
    }

    private List<String> texts() {
        return callOnEdt(() ->
                ComponentFinder.findAll(bar, JLabel.class).map(JLabel::getText).toList());
    }
}
