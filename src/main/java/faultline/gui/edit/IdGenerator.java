package faultline.gui.edit;

import java.util.Collection;

/** Ids for new obstacles. */
public final class IdGenerator {

    private IdGenerator() {}

    /**
     * An id that is not taken: the wanted one, or its stem with the first free number behind it.
     *
     * @param wanted such as {@code circle} or {@code circle-2}
     * @param taken ids that are taken
     * @return such as {@code circle-3}
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
