package faultline.scenario.xml;

import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import java.util.Collection;
import java.util.stream.Collectors;

/** The rules for values in a scenario file, with the English text of each. */
public enum Allowed implements Message.Template {
    /** A number within limits. */
    NUMBER("a number {0}"),
    /** A number within limits, without exponent. */
    PLAIN_NUMBER("a number without exponent, {0}"),
    /** A whole number within limits. */
    WHOLE_NUMBER("a whole number {0}"),
    /** Limits of which both are included. */
    CLOSED("from {0} to {1}"),
    /** Limits of which the upper one is included. */
    HALF_OPEN("more than {0} and at most {1}"),
    /** Limits of which neither is included. */
    OPEN("more than {0} and less than {1}"),
    /** A number of metres. */
    METRES("{0} metres"),
    /** A number of degrees. */
    DEGREES("{0} degrees"),
    /** A number of degrees per second. */
    TURN_RATE("{0} degrees per second"),
    /** A number of metres per second. */
    SPEED("{0} metres per second"),
    /** A number of metres per second and volt. */
    SPEED_CONSTANT("{0} metres per second and volt"),
    /** A number of seconds. */
    SECONDS("{0} seconds"),
    /** A number of volts. */
    VOLTS("{0} volts"),
    /** A number without a unit. */
    UNITLESS("{0}"),
    /** An id. */
    ID("1 to 100 characters, none of them a comma, a double quote or a control character"),
    /** A text of limited length. */
    CHARACTERS("at most {0} characters"),
    /** A list of points. */
    POINTS("{0} or more points as x,y with blanks between them, each number {1}"),
    /** A list of rings of points. */
    RINGS("rings of 3 or more points as x,y with blanks between them, separated by |, each number {0}"),
    /** A list of recorded decisions. */
    DECISIONS("voltages as left,right or left,right*ticks with blanks between them"),
    /** Recorded decisions within a limit: the last tick. */
    DECISIONS_END("decisions that end at tick {0} or earlier"),
    /** The ticks of recorded decisions in a scenario that is to be run. */
    RECORDED_TICKS("at least 1, because a run breaks where the record ends"),
    /** No attribute. */
    NONE("none"),
    /** No content. */
    NOTHING("nothing"),
    /** Text as the content. */
    TEXT("text"),
    /** Elements as the content. */
    ELEMENTS("elements only: {0}"),
    /** No value, because the fault's kind takes none. */
    NO_VALUE("none, because a fault of kind {0} takes no value"),
    /** No id, because nothing has one. */
    NO_IDS("none: there are none"),
    /** The id of a sensor. */
    SENSORS("one of the robot''s sensors: {0}"),
    /** The id of an obstacle. */
    OBSTACLES("one of the obstacles: {0}"),
    /** The name of a state of a controller whose states are not known. */
    STATE("the name of a state"),
    /** The name of a controller's state. */
    STATES("one of the controller''s states: {0}"),
    /** The name of a controller. */
    CONTROLLERS("{0} or a controller in Java from --jar"),
    /** A text that is not translated, such as names of a file. */
    UNTRANSLATED("{0}"),
    /** A list of names with a suggestion. */
    HINT("{0}; did you mean \"{1}\"?"),
    /** A list of names that is cut short. */
    MORE("{0} and {1} more"),
    /** A truth value. */
    FLAG("true or false"),
    /** The kind of file that is expected. */
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

    /**
     * {@return names as a list, no more than the first dozen}
     *
     * @param names the names
     */
    public static Message names(Collection<String> names) {
        String first = names.stream().limit(MAX_NAMES).map(MessageText::excerpt).collect(Collectors.joining(", "));
        return names.size() > MAX_NAMES ? MORE.with(first, names.size() - MAX_NAMES) : UNTRANSLATED.with(first);
    }

    /**
     * {@return names as a list, followed by the one that is most similar to a given name, if any is}
     *
     * @param names the names
     * @param given the given name
     */
    public static Message names(Collection<String> names, String given) {
        return withHint(names(names), given, names);
    }

    /**
     * {@return a rule, followed by the known name that is most similar to a given one, if any is}
     *
     * @param rule the rule
     * @param given the given name
     * @param known the known names
     */
    public static Message withHint(Message rule, String given, Collection<String> known) {
        return DidYouMean.nearest(given, known)
                .map(name -> HINT.with(rule, MessageText.excerpt(name)))
                .orElse(rule);
    }
}
