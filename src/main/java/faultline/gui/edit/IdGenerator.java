package faultline.gui.edit;

import faultline.io.MessageText;
import faultline.scenario.xml.ScenarioLimits;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/** Generates ids of new obstacles and sensors, all of them different. */
public final class IdGenerator {

    private static final Pattern NUMBER = Pattern.compile("-\\d{1,6}$");

    private final Set<String> taken;
    /** The first number that may be free, by stem. */
    private final Map<String, Integer> numbers = new HashMap<>();

    /** Creates a generator of ids that differ from those that are taken. */
    public IdGenerator(Collection<String> taken) {
        this.taken = new HashSet<>(taken);
    }

    /** Returns one new id, as {@link #next} does. */
    public static String uniqueId(String wanted, Collection<String> taken) {
        return taken.contains(wanted) ? new IdGenerator(taken).next(wanted) : wanted;
    }

    /**
     * Returns the wanted id, such as {@code circle-2}, or its stem with the first free number, such as
     * {@code circle-3}, if it is taken. A stem that is too long for a file is shortened.
     */
    public String next(String wanted) {
        if (taken.add(wanted)) {
            return wanted;
        }
        String stem = NUMBER.matcher(wanted).replaceFirst("");
        int number = numbers.getOrDefault(stem, 2);
        while (!taken.add(numbered(stem, number))) {
            number++;
        }
        numbers.put(stem, number + 1);
        return numbered(stem, number);
    }

    private static String numbered(String stem, int number) {
        String end = "-" + number;
        return MessageText.start(stem, ScenarioLimits.MAX_ID_LENGTH - end.length()) + end;
    }
}
