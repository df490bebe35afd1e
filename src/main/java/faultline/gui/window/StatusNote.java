package faultline.gui.window;

import faultline.gui.theme.UiText;
import faultline.world.Snapshot;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import javax.swing.JLabel;

/**
 * A sentence that stays for as long as it takes to read, or is kept, and no longer than it holds in the world that is
 * shown.
 */
final class StatusNote extends JLabel {

    /** Minimum time for which a note stays, milliseconds. */
    private static final int MIN_MILLIS = 5000;
    /** Minimum time for which a note stays that no longer holds, milliseconds. */
    private static final int MIN_READ_MILLIS = 1000;
    /** Time per character for which a note stays, so that a long one can be read to its end, milliseconds. */
    private static final int MILLIS_PER_CHARACTER = 80;

    private static final int NANOS_PER_MILLI = 1_000_000;

    private final transient LongSupplier nanoTime;
    /** The time at which the note was shown. */
    private long shownNanos;
    /** How long the note stays, milliseconds; 0 if there is none. */
    private int stayMillis;
    /** Whether the note still holds in a world. */
    private transient Predicate<Snapshot> holds = world -> true;

    StatusNote(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
        UiText.name(this, "status.note");
    }

    void show(String sentence, Predicate<Snapshot> newHolds) {
        shownNanos = nanoTime.getAsLong();
        holds = newHolds;
        setText(sentence);
        setToolTipText(sentence);
        stayMillis = Math.max(MIN_MILLIS, MILLIS_PER_CHARACTER * sentence.length());
    }

    /** Shows a sentence for as long as it holds, unless another one replaces it. */
    void keep(String sentence, Predicate<Snapshot> newHolds) {
        show(sentence, newHolds);
        stayMillis = 0;
    }

    /** Removes the sentence. */
    void clear() {
        setText("");
        setToolTipText(null);
        stayMillis = 0;
        holds = world -> true;
    }

    /** Removes a sentence if it is still shown. */
    void remove(String sentence) {
        if (getText().equals(sentence)) {
            clear();
        }
    }

    /** Removes the sentence if it does not hold in a world, after a moment in which it can be noticed. */
    void removeUnlessHoldsIn(Snapshot world) {
        if (isOlderThan(MIN_READ_MILLIS) && !holds.test(world)) {
            clear();
        }
    }

    /** Removes the sentence after the time that it takes to read. */
    void removeWhenRead() {
        if (isPresent() && isOlderThan(stayMillis)) {
            clear();
        }
    }

    /** Returns whether there is a sentence that will be removed. */
    boolean isPresent() {
        return stayMillis > 0;
    }

    private boolean isOlderThan(int millis) {
        return nanoTime.getAsLong() - shownNanos > (long) millis * NANOS_PER_MILLI;
    }
}
