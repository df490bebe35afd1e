package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;

/** What can be wrong with a scenario file, with the English text of each problem. */
public enum ProblemKind implements Message.Template {
    VALUE("{0} of <{1}> is \"{2}\"; expected {3}"),
    UNTIL("until of <fault> is {0}; expected a time after at, which is {1}"),
    UNKNOWN_ATTRIBUTE("<{0}> has no attribute \"{1}\"; expected {2}"),
    MISSING_ATTRIBUTE("<{0}> lacks the attribute \"{1}\"; expected {2}"),
    TOO_MANY_POINTS(
            "{0} of <{1}> holds more points than are left of the {2} obstacles and points that a file may hold"),
    TEXT("<{0}> holds the text \"{1}\"; expected {2}"),
    UNKNOWN_ELEMENT("<{0}> may not hold <{1}>; expected {2}"),
    DUPLICATE_ELEMENT("<{0}> holds a second <{1}>; expected one"),
    LOOP_TIME("<motion> goes round its way-points in {0} s; expected {1} s or more"),
    WHEEL_SPEED(
            "<motor> drives its wheels at up to {0} m/s (speedConstant times maxVoltage); expected {1} m/s or less"),
    SPIN_RATE("<robot> could spin at {0} rad/s (twice its wheels'' top speed by its track);"
            + " expected {1} rad/s or less"),
    ROOT("the root element is <{0}>; expected <scenario xmlns=\"{1}\">"),
    MISSING_ELEMENT("<scenario> lacks the element <{0}>; expected one"),
    START_OUTSIDE("<robot> starts at {0} outside of the enclosed world; expected x from 0 to {1} and y from 0 to {2}"),
    START_OVERLAPS("<robot> starts at {0} where it touches or overlaps \"{1}\";"
            + " expected a place with room for the whole platform"),
    OBSTACLE_COUNT("<put> holds {0} obstacles; expected one of {1}"),
    TOO_MANY_ELEMENTS("the file has too many elements; expected {0}"),
    TOO_DEEP("the elements are nested too deep; expected {0}"),
    DUPLICATE_ID("id of <{0}> is \"{1}\", which the one in line {2} has already; expected each id once"),
    TOO_MANY_PARTS("<world> holds too much; expected {0} obstacles and points together"),
    TOO_MANY_SENSORS("<robot> has too many sensors; expected {0}"),
    RESERVED_ID("id of <{0}> is \"{1}\"; expected any other: it names the wall round the world"),
    TOO_MANY_MOVING("<{0}> \"{1}\" is moving obstacle number {2}; expected {3} (maxMoving of <world>)"),
    ENCODING("the bytes are not text in the encoding that the file names; expected UTF-8"),
    UNREADABLE_XML("the file cannot be read as XML"),
    SCHEMA("this does not conform to the schema {0}"),
    DOCTYPE("the file has a DOCTYPE; expected none"),
    PARSER_LIMIT("the file goes beyond a limit of the XML parser"),
    NOT_XML("this is not XML; expected a document that begins with <{0}>"),
    NOT_XML_AFTER("this is not XML; expected a document that begins with <{0}>, after \"{1}\""),
    MALFORMED("this is not well-formed XML"),
    MALFORMED_AFTER("this is not well-formed XML, after \"{0}\""),
    MALFORMED_INSIDE("this is not well-formed XML, inside <{0}> of line {1}"),
    MALFORMED_AFTER_INSIDE("this is not well-formed XML, after \"{0}\", inside <{1}> of line {2}"),
    NO_SUCH_FILE("there is no such file"),
    UNREADABLE_FILE("the file cannot be read"),
    FOLDER("this is a folder; expected a {0}"),
    IRREGULAR_FILE("this is no regular file; expected a {0}"),
    TOO_MANY_BYTES("the file has {0} bytes; expected {1}"),
    NOT_SHIPPED("no such scenario ships with the program"),
    UNREADABLE_RESOURCE("the scenario cannot be read from the program''s own files"),
    EMPTY_FILE("the file is empty; expected a scenario"),
    MORE("and {0} more problems"),
    NOT_SAVED("the scenario cannot be saved: {0}"),
    NOT_REPRODUCIBLE("it would not read back the same");

    private final String english;

    ProblemKind(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "problem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
