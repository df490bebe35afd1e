package faultline.gui.edit;

import java.util.Collection;

/** Generates ids of new obstacles. */
public final class IdGenerator {

    private IdGenerator() {}

    /**
     * Returns the wanted id, such as {@code circle-2}, or its stem with the first free number, such as
     * {@code circle-3}, if it is taken.
     */
    public static String uniqueId(String wanted, Collection<String> taken) {
        if (!taken.contains(wanted)) {
            return wanted;
        }
        String stem = wanted.replaceFirst("-\\d{1,6}$", "");
        int number = 2;
        while (taken.contains(stem + "-" + number)) {
            number++;
        }
        return stem + "-" + number;
    }
}
