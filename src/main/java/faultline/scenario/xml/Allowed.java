package faultline.scenario.xml;

import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import java.util.Collection;
import java.util.stream.Collectors;

/** The rules for values in a scenario file, with the English text of each. */
public enum Allowed implements Message.Template {
    NUMBER("a number {0}"),
    PLAIN_NUMBER("a number without exponent, {0}"),
    WHOLE_NUMBER("a whole number {0}"),
    CLOSED("from {0} to {1}"),
    HALF_OPEN("more than {0} and at most {1}"),
    OPEN("more than {0} and less than {1}"),
    METRES("{0} metres"),
    DEGREES("{0} degrees"),
    TURN_RATE("{0} degrees per second"),
    SPEED("{0} metres per second"),
    SPEED_CONSTANT("{0} metres per second and volt"),
    SECONDS("{0} seconds"),
    VOLTS("{0} volts"),
    UNITLESS("{0}"),
    ID("1 to 100 characters, none of them a comma, a double quote or a control character"),
    POINTS("{0} or more points as x,y with blanks between them, each number {1}"),
    RINGS("rings of 3 or more points as x,y with blanks between them, separated by |, each number {0}"),
    DECISIONS("voltages as left,right or left,right*ticks with blanks between them"),
    NONE("none"),
    NOTHING("nothing"),
    TEXT("text"),
    ELEMENTS("elements only: {0}"),
    NO_VALUE("none, because a fault of kind {0} takes no value"),
    NO_IDS("none: there are none"),
    SENSORS("one of the robot''s sensors: {0}"),
    OBSTACLES("one of the obstacles: {0}"),
    STATES("one of the controller''s states: {0}"),
    HINT("{0}; did you mean \"{1}\"?"),
    MORE("{0} and {1} more"),
    FLAG("true or false"),
    SCENARIO_FILE("scenario file");

    private static final int MAX_NAMES = 12;

    private final String english;

    Allowed(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "allowed." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }

    /** Returns names as a list, no more than the first dozen. */
    public static Object names(Collection<String> names) {
        String first = names.stream().limit(MAX_NAMES).map(MessageText::oneLine).collect(Collectors.joining(", "));
        return names.size() > MAX_NAMES ? MORE.with(first, names.size() - MAX_NAMES) : first;
    }

    /** Returns names as a list, followed by the one that is most similar to a given name, if any is. */
    public static Object names(Collection<String> names, String given) {
        return withHint(names(names), given, names);
    }

    /** Returns a rule, followed by the known name that is most similar to a given one, if any is. */
    static Object withHint(Object rule, String given, Collection<String> known) {
        return DidYouMean.nearest(given, known)
                .<Object>map(name -> HINT.with(rule, MessageText.excerpt(name)))
                .orElse(rule);
    }
}
