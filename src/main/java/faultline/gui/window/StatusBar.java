package faultline.gui.window;

import faultline.control.FollowerState;
import faultline.engine.Frame;
import faultline.engine.Session;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.text.StateText;
import faultline.gui.text.Texts;
import faultline.gui.text.Wordings;
import faultline.gui.theme.RuleBorder;
import faultline.gui.theme.TextSize;
import faultline.world.Snapshot;
import java.awt.EventQueue;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;

/**
 * One line about the run: whether it runs, its time and pace, the controller's state, the robot's pose, and where the mouse is; at its
 * end what was refused and why. Where the line is short, the cells at its end give way, to the sentence too.
 */
final class StatusBar extends JPanel {

    private static final int GAP = 14;
    /** For how many snapshots a note stays at least; at sixty in a second, five seconds. */
    private static final int NOTE_STAYS = 300;
    /** And for how many of them for each of its letters, so that a long one can be read to its end. */
    private static final int LETTER_STAYS = 5;

    private final StatusCell running = cell("status.running",
            Stream.of("runs", "paused", "collided", "failed").map(state -> Texts.text("status." + state)).toArray(String[]::new));
    private final StatusCell time = cell("status.time", "t 00000.000 s");
    private final StatusCell tick = cell("status.tick", "tick 00000000");
    private final StatusCell pace = cell("status.pace", "00000.00× real time");
    private final StatusCell state = cell("status.state",
            Stream.of(FollowerState.values()).map(state -> StateText.name(state.name())).toArray(String[]::new));
    private final StatusCell pose = cell("status.pose", "x -00.000  y -00.000  θ -000.0°");
    private final StatusCell cursor = cell("status.cursor", "cursor -00.00, -00.00");
    private final StatusCell scale = cell("status.scale", "0000 px/m");
    private final JLabel note = new JLabel();
    private int noteLeft;
    private int refusals;

    StatusBar() {
        super(new StatusLayout(TextSize.scaled(GAP), StatusCell.class::isInstance));
        setBorder(RuleBorder.above(4, 14, 4));
        for (StatusCell cell : new StatusCell[] {running, time, pace, state, pose, cursor, scale, tick}) {
            add(cell);
        }
        note.getAccessibleContext().setAccessibleName(Texts.text("status.note"));
        add(note);
    }

    private static StatusCell cell(String key, String... widest) {
        return new StatusCell(Texts.text(key), widest);
    }

    /** Shows how the run is. */
    void show(Frame frame, Session.Status status) {
        assert EventQueue.isDispatchThread();
        Snapshot world = frame.world();
        running.show(Texts.text(status.failure().isPresent() ? "status.failed" : world.collision().isPresent() ? "status.collided"
                : status.running() ? "status.runs" : "status.paused"));
        time.show(format("t %.3f s", world.time()));
        tick.show(format("tick %d", world.tick()));
        pace.show(status.achieved() > 0 ? format("%.2f× ", status.achieved()) + Texts.text("status.realTime") : "–");
        state.show(StateText.name(frame.control().state()));
        pose.show(text(world.pose()));
        showNote(status);
    }

    private static String text(Pose pose) {
        // Whole tenths, because a rounded -0.04 would be written as -0.0.
        double degrees = Math.round(10 * Math.toDegrees(Math.IEEEremainder(pose.heading(), 2 * Math.PI))) / 10.0;
        return format("x %.3f  y %.3f  θ %.1f°", pose.x(), pose.y(), degrees);
    }

    /** Why a run broke off stays; why a command was refused goes after a while. */
    private void showNote(Session.Status status) {
        status.failure().ifPresent(this::showNote);
        if (status.refusals() != refusals) {
            refusals = status.refusals();
            status.lastRefusal().map(Wordings::text).ifPresent(this::showNote);
        } else if (noteLeft > 0 && --noteLeft == 0) {
            note.setText("");
        }
    }

    /** Shows a sentence for as long as it takes to read. */
    void showNote(String sentence) {
        note.setText(sentence);
        note.setToolTipText(sentence);
        noteLeft = Math.max(NOTE_STAYS, LETTER_STAYS * sentence.length());
    }

    /** Forgets what belonged to another session. */
    void reset() {
        refusals = 0;
    }

    /** Shows where the mouse is in the world. */
    void showCursor(Optional<Vec> place) {
        cursor.show(place.map(at -> Texts.text("status.at", format("%.2f", at.x()), format("%.2f", at.y()))).orElse(""));
    }

    /** Shows how many pixels a metre has. */
    void showScale(double pixelsPerMetre) {
        scale.show(format("%.0f px/m", pixelsPerMetre));
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
