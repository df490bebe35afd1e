package faultline.gui.bar;

import faultline.gui.theme.UiText;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import javax.swing.JLabel;

/**
 * Shows the first of these sentences that exists: a note, for as long as it takes to read; the newest of the notes that
 * are kept; the condition of the run; and the line that a program has printed, for as long as it takes to read.
 */
final class StatusNote extends JLabel {

    /** Minimum time for which a note stays, milliseconds. */
    private static final int MIN_MILLIS = 5000;
    /** Minimum time for which a note that no longer holds stays, milliseconds. */
    private static final int MIN_READ_MILLIS = 1000;
    /** Time per character for which a note stays, so that a long one can be read to its end, milliseconds. */
    private static final int MILLIS_PER_CHARACTER = 80;

    private static final int NANOS_PER_MILLI = 1_000_000;

    /** A sentence, when it was shown, and whether it still holds in a world. */
    private record Sentence(String text, long shownNanos, Predicate<Snapshot> holds) {
        static final Sentence NONE = new Sentence("", 0, world -> true);

        boolean isNone() {
            return text.isEmpty();
        }

        boolean isOlderThan(int millis, long nanos) {
            return nanos - shownNanos > (long) millis * NANOS_PER_MILLI;
        }

        /** Returns whether the sentence does not hold, after a moment in which it can be noticed. */
        boolean isOver(Snapshot world, long nanos) {
            return isOlderThan(MIN_READ_MILLIS, nanos) && !holds.test(world);
        }

        boolean isRead(long nanos) {
            return isOlderThan(Math.max(MIN_MILLIS, MILLIS_PER_CHARACTER * text.length()), nanos);
        }
    }

    private final transient LongSupplier nanoTime;
    private transient Sentence note = Sentence.NONE;
    /** The kept notes, the newest last. */
    private final transient List<Sentence> kept = new ArrayList<>();

    private String condition = "";
    private transient Sentence line = Sentence.NONE;

    StatusNote(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
        UiText.name(this, "status.note");
    }

    /** Shows a sentence for as long as it takes to read, and no longer than it holds. */
    void show(String sentence, Predicate<Snapshot> holds) {
        note = createSentence(sentence, holds);
        showFirst();
    }

    /** Shows a sentence for as long as it holds, except while notes about something else are read. */
    void keep(String sentence, Predicate<Snapshot> holds) {
        kept.removeIf(old -> old.text().equals(sentence));
        kept.add(createSentence(sentence, holds));
        showFirst();
    }

    /** Shows a sentence about the run while no note is shown, empty for none. */
    void setCondition(String sentence) {
        condition = sentence;
        showFirst();
    }

    /** Shows a line that a program has printed for as long as it takes to read, while there is nothing else to show. */
    void showLine(String text) {
        line = createSentence(text, world -> true);
        showFirst();
    }

    private Sentence createSentence(String text, Predicate<Snapshot> holds) {
        return new Sentence(text, nanoTime.getAsLong(), holds);
    }

    /** Removes all sentences but the condition of the run. */
    void clear() {
        note = Sentence.NONE;
        kept.clear();
        line = Sentence.NONE;
        showFirst();
    }

    /** Removes a sentence if it is still there. */
    void remove(String sentence) {
        note = note.text().equals(sentence) ? Sentence.NONE : note;
        kept.removeIf(old -> old.text().equals(sentence));
        line = line.text().equals(sentence) ? Sentence.NONE : line;
        showFirst();
    }

    /** Removes what does not hold in a world, and what has been read. */
    void update(Snapshot world) {
        long now = nanoTime.getAsLong();
        if (note.isOver(world, now) || note.isRead(now)) {
            note = Sentence.NONE;
        }
        kept.removeIf(sentence -> sentence.isOver(world, now));
        if (line.isRead(now)) {
            line = Sentence.NONE;
        }
        showFirst();
    }

    /** Returns whether there is a sentence that will be removed when it has been read. */
    boolean isPresent() {
        return !note.isNone() || !line.isNone();
    }

    private void showFirst() {
        String text = firstText();
        if (!text.equals(getText())) {
            setText(text);
            setToolTipText(text.isEmpty() ? null : text);
        }
    }

    private String firstText() {
        if (!note.isNone()) {
            return note.text();
        }
        if (!kept.isEmpty()) {
            return kept.get(kept.size() - 1).text();
        }
        return condition.isEmpty() ? line.text() : condition;
    }
}
