package faultline.gui.bar;

import faultline.control.FollowerState;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.text.AngleText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.text.RefusalText;
import faultline.gui.text.StateText;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.SeparatorBorder;
import faultline.world.Refusal;
import faultline.world.Snapshot;
import java.awt.EventQueue;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JPanel;

/**
 * One line about the run: its state, time, pace, controller state, pose and the cursor position, and at the end a note.
 * If the line is too narrow, the last cells are hidden first, also in favour of the note.
 */
public final class StatusBar extends JPanel {

    private static final int GAP = 14;
    /** The smallest scale that is shown without decimals, pixels per metre. */
    private static final int WHOLE_SCALE = 10;
    /** The longest usual time of a run, seconds. */
    private static final int LONG_TIME = 88_888;

    /** The length of a tick of the run, seconds; 0 before the first one. */
    private double dt;

    private final StatusCell running =
            cell("status.runState", () -> Stream.of("running", "paused", "collided", "failed")
                    .map(state -> Messages.get("status." + state)));
    private final StatusCell time = cell("status.time", () -> Stream.of(timeText(LONG_TIME)));
    private final StatusCell tick = cell("status.tick", () -> Stream.of(tickText(10_000_000)));
    private final StatusCell pace = cell("status.pace", "00000.00× real time");
    private final StatusCell state =
            cell("status.state", () -> Stream.of(FollowerState.values()).map(StateText::name));
    private final StatusCell pose = cell("status.pose", "x -00.000  y -00.000  θ -000.0°");
    private final StatusCell cursor = cell("status.cursor", "cursor -00.00, -00.00");
    private final StatusCell scale = cell("status.scale", "0000 px/m");
    private final StatusNote note;
    private final transient StalledRun stalledRun;
    private transient Runnable noteListener = () -> {};
    /** Null while the cursor is outside the canvas. */
    private transient Vector2 cursorPoint;

    private int shownRefusals;

    /** Creates a bar that shows nothing yet. */
    public StatusBar() {
        this(System::nanoTime);
    }

    StatusBar(LongSupplier nanoTime) {
        super(new StatusLayout(GAP, StatusCell.class::isInstance));
        note = new StatusNote(nanoTime);
        stalledRun = new StalledRun(nanoTime);
        setBorder(SeparatorBorder.above(3, 14, 3));
        for (StatusCell cell : new StatusCell[] {running, time, pace, state, pose, cursor, scale, tick}) {
            add(cell);
        }
        RefreshSteps.add(cursor, cell -> showCursor(cursorPoint));
        add(note);
    }

    private static StatusCell cell(String key, String widest) {
        return cell(key, () -> Stream.of(widest));
    }

    private static StatusCell cell(String key, Supplier<Stream<String>> texts) {
        return new StatusCell(key, texts);
    }

    /** Notes that the user pauses the run. */
    public void pauseRequested() {
        stalledRun.pauseRequested();
    }

    /** Shows the state of the run. */
    public void setFrame(SessionFrame frame, SessionStatus status) {
        assert EventQueue.isDispatchThread();
        Snapshot world = frame.snapshot();
        running.setStatusText(Messages.get(
                status.failure().isPresent()
                        ? "status.failed"
                        : world.collision().isPresent()
                                ? "status.collided"
                                : status.running() ? "status.running" : "status.paused"));
        showTime(world.time(), frame.dt());
        tick.setStatusText(tickText(world.tick()));
        boolean stalled = stalledRun.isStalled(frame, status);
        pace.setStatusText(
                status.achievedSpeed() > 0 && !stalled
                        ? NumberText.format("%.2f× ", status.achievedSpeed()) + Messages.get("status.realTime")
                        : "–");
        state.setStatusText(StateText.name(frame.telemetry().state()));
        pose.setStatusText(poseText(world.pose()));
        note.setCondition(conditionOf(status, stalled));
        note.update(world);
        if (status.refusals() != shownRefusals) {
            shownRefusals = status.refusals();
            status.lastRefusal()
                    .ifPresent(refusal ->
                            showNote(RefusalText.format(refusal), now -> !isPlacedElsewhere(refusal, world, now)));
        }
    }

    /** Returns whether an obstacle that was refused a place has got another one since, other than by its motion. */
    private static boolean isPlacedElsewhere(Refusal refusal, Snapshot refused, Snapshot now) {
        return refusal.reason() == Refusal.Reason.OVERLAPS_ROBOT
                && now.obstacles().stream()
                        .filter(obstacle -> obstacle.id().equals(refusal.subject()) && !obstacle.isMoving())
                        .anyMatch(obstacle -> !refused.obstacles().contains(obstacle));
    }

    /** Says why a run has failed, or why nothing moves and a run does not pause at once; empty otherwise. */
    private static String conditionOf(SessionStatus status, boolean stalled) {
        String waiting = stalled ? Messages.get("status.stalled") : "";
        return status.failure().map(reason -> Messages.get(reason)).orElse(waiting);
    }

    private void showTime(double seconds, double tickLength) {
        boolean hasNewTicks = tickLength != dt;
        dt = tickLength;
        time.setStatusText(timeText(seconds));
        if (hasNewTicks) {
            RefreshSteps.run(time);
            revalidate();
        }
    }

    /** Returns a time with the decimals that tell the ticks of the run apart. */
    private String timeText(double seconds) {
        return "t " + NumberText.clock(seconds, dt) + " s";
    }

    private static String tickText(long tick) {
        return Messages.get("status.tickCount", Long.toString(tick));
    }

    private static String poseText(Pose pose) {
        return NumberText.format("x %.3f  y %.3f  θ %s°", pose.x(), pose.y(), AngleText.degrees(pose.heading(), 1));
    }

    /** Sets what is called when a note is shown that {@link #setFrame} will remove after a time. */
    public void setNoteListener(Runnable listener) {
        noteListener = listener;
    }

    /** Removes all notes. */
    public void clearNotes() {
        note.clear();
    }

    /** Removes a sentence if it is still there. */
    public void removeNote(String sentence) {
        note.remove(sentence);
    }

    /** Shows a sentence for as long as it takes to read. */
    public void showNote(String sentence) {
        showNote(sentence, world -> true);
    }

    /** Shows a sentence for as long as it takes to read, and no longer than it holds in the world that is shown. */
    public void showNote(String sentence, Predicate<Snapshot> holds) {
        note.show(sentence, holds);
        noteListener.run();
    }

    /** Shows a sentence until it is removed, except while notes about something else are read. */
    public void keepNote(String sentence) {
        note.keep(sentence, world -> true);
    }

    /** Shows a sentence for as long as it holds, except while notes about something else are read. */
    public void keepNote(String sentence, BooleanSupplier holds) {
        note.keep(sentence, world -> holds.getAsBoolean());
        noteListener.run();
    }

    /** Shows a line that a program has printed, while there is nothing else to show. */
    public void showLine(String text) {
        note.showLine(text);
        noteListener.run();
    }

    /** Returns whether there is a note that will be removed. */
    public boolean isNoteShown() {
        return note.isPresent();
    }

    /** Removes what belongs to the previous session. */
    public void reset() {
        shownRefusals = 0;
        stalledRun.reset();
    }

    /** Shows the cursor position in the world, null if the cursor is outside. */
    public void showCursor(Vector2 at) {
        cursorPoint = at;
        cursor.setStatusText(
                at == null
                        ? ""
                        : Messages.get(
                                "status.at", NumberText.format("%.2f", at.x()), NumberText.format("%.2f", at.y())));
    }

    /** Shows the scale of the canvas in pixels per metre. */
    public void showScale(double pixelsPerMetre) {
        scale.setStatusText(
                NumberText.format(pixelsPerMetre < WHOLE_SCALE ? "%.3f px/m" : "%.0f px/m", pixelsPerMetre));
    }
}
