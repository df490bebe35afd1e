package faultline.gui.form;

import java.awt.EventQueue;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import javax.swing.ComboBoxModel;
import javax.swing.JComboBox;

/**
 * Selects an entry of a combo box by the letters of its name, each typed within a second of the one before. The first
 * letter selects the next entry, as each repetition of it does. Several letters select the entry with this complete
 * name, or else an entry that begins with them: that which was selected before, or else the next one.
 */
final class NameKeySelection<T> implements JComboBox.KeySelectionManager {

    private static final long MAX_MILLIS = 1000;

    private final Function<T, String> name;
    private final LongSupplier clock;
    private String typed = "";
    private long lastMillis;
    /** The entry that was selected before the first letter. */
    private int before;
    /** The entry that was selected after the last letter. */
    private int after;

    private NameKeySelection(Function<T, String> name, LongSupplier clock) {
        this.name = name;
        this.clock = clock;
    }

    /** Lets letters select the entries of a combo box by their names; returns what finds the entries. */
    static <T> NameKeySelection<T> install(JComboBox<T> box, Function<T, String> name) {
        return install(box, name, EventQueue::getMostRecentEventTime);
    }

    /** Does the same with a clock, milliseconds. */
    static <T> NameKeySelection<T> install(JComboBox<T> box, Function<T, String> name, LongSupplier clock) {
        NameKeySelection<T> keys = new NameKeySelection<>(name, clock);
        box.setKeySelectionManager(keys);
        return keys;
    }

    @Override
    public int selectionForKey(char key, ComboBoxModel<?> model) {
        int selected = IntStream.range(0, model.getSize())
                .filter(i -> model.getElementAt(i).equals(model.getSelectedItem()))
                .findFirst()
                .orElse(-1);
        return indexForKey(key, model, selected);
    }

    /** Returns the index of the entry for a letter, given the selected entry, -1 for none; -1 if there is none. */
    int indexForKey(char key, ComboBoxModel<?> model, int selected) {
        long now = clock.getAsLong();
        String letter = String.valueOf(key).toLowerCase(Locale.ROOT);
        boolean continues = now - lastMillis < MAX_MILLIS && selected == after && !typed.equals(letter);
        typed = continues ? typed + letter : letter;
        before = continues ? before : selected;
        lastMillis = now;
        int found = find(selected, model);
        after = found < 0 ? selected : found;
        return found;
    }

    /** Returns the entry for what has been typed, given the selected one; -1 if there is none. */
    private int find(int selected, ComboBoxModel<?> model) {
        IntPredicate begins = i -> nameOf(i, model).startsWith(typed);
        if (typed.length() == 1) {
            return first(selected + 1, model, begins);
        }
        int complete = first(0, model, i -> nameOf(i, model).equals(typed));
        return complete >= 0 ? complete : before >= 0 && begins.test(before) ? before : first(selected, model, begins);
    }

    /** Returns the first entry from an index on, and from the start again, for which a condition holds; -1 for none. */
    private static int first(int from, ComboBoxModel<?> model, IntPredicate condition) {
        int size = model.getSize();
        return IntStream.range(0, size)
                .map(i -> Math.floorMod(from + i, size))
                .filter(condition)
                .findFirst()
                .orElse(-1);
    }

    @SuppressWarnings("unchecked")
    private String nameOf(int index, ComboBoxModel<?> model) {
        return name.apply((T) model.getElementAt(index)).toLowerCase(Locale.ROOT);
    }
}
