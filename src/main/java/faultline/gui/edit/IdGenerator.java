package faultline.gui.edit;

import faultline.io.MessageText;
import faultline.scenario.xml.ScenarioLimits;
import java.util.Collection;

/** Generates ids of new obstacles. */
public final class IdGenerator {

    private IdGenerator() {}

    /**
     * Returns the wanted id, such as {@code circle-2}, or its stem with the first free number, such as
     * {@code circle-3}, if it is taken. A stem that is too long for a file is shortened.
     */
    public static String uniqueId(String wanted, Collection<String> taken) {
        if (!taken.contains(wanted)) {
            return wanted;
        }
        String stem = wanted.replaceFirst("-\\d{1,6}$", "");
        int number = 2;
        while (taken.contains(numbered(stem, number))) {
            number++;
        }
        return numbered(stem, number);
    }

    private static String numbered(String stem, int number) {
        String end = "-" + number;
        return MessageText.start(stem, ScenarioLimits.MAX_ID_LENGTH - end.length()) + end;
    }
}
