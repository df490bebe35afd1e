package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;

/** The kinds of problem of a scenario file, with the English text of each. */
public enum ProblemKind implements Message.Template {
    /** An attribute has an invalid value. */
    VALUE("{0} of <{1}> is \"{2}\"; expected {3}"),
    /** A fault ends before it begins. */
    UNTIL("until of <fault> is {0}; expected a time after at, which is {1}"),
    /** An element has an unknown attribute. */
    UNKNOWN_ATTRIBUTE("<{0}> has no attribute \"{1}\"; expected {2}"),
    /** A required attribute is missing. */
    MISSING_ATTRIBUTE("<{0}> lacks the attribute \"{1}\"; expected {2}"),
    /** The obstacles have too many points together. */
    TOO_MANY_POINTS("{0} of <{1}> has too many points; expected at most {2} obstacles and points in the file"),
    /** An element contains text that it may not contain. */
    TEXT("<{0}> contains the text \"{1}\"; expected {2}"),
    /** An element contains too much text. */
    TEXT_LENGTH("<{0}> contains {1} characters; expected at most {2}"),
    /** An element contains an unknown element. */
    UNKNOWN_ELEMENT("<{0}> must not contain <{1}>; expected {2}"),
    /** An element occurs twice. */
    DUPLICATE_ELEMENT("<{0}> contains a second <{1}>; expected one"),
    /** The loop of an obstacle takes too little time. */
    LOOP_TIME("the loop of <motion> takes {0} s; expected {1} s or more"),
    /** The motors drive the wheels too fast. */
    WHEEL_SPEED(
            "<motor> drives its wheels at up to {0} m/s (speedConstant times maxVoltage); expected {1} m/s or less"),
    /** The robot could turn too fast. */
    SPIN_RATE("<robot> could spin at {0} rad/s (twice the maximum wheel speed divided by the track);"
            + " expected {1} rad/s or less"),
    /** A sensor that is none of the known ones has no place on the robot. */
    NEW_SENSOR("<sensor> \"{0}\" lacks x, y and bearing; expected these attributes for a new sensor, or one of {1}"),
    /** The root element is not that of a scenario. */
    ROOT("the root element is <{0}>; expected <scenario xmlns=\"{1}\">"),
    /** A required element is missing. */
    MISSING_ELEMENT("<scenario> lacks the element <{0}>; expected one"),
    /** The robot starts outside the enclosed world. */
    START_OUTSIDE("<robot> starts at {0} outside of the enclosed world; expected x from 0 to {1} and y from 0 to {2}"),
    /** The robot starts inside an obstacle. */
    START_OVERLAPS("<robot> starts at {0} where it touches or overlaps \"{1}\";"
            + " expected a place with room for the whole platform"),
    /** A command does not contain exactly one obstacle. */
    OBSTACLE_COUNT("<put> contains {0} obstacles; expected one of {1}"),
    /** The file has too many elements. */
    TOO_MANY_ELEMENTS("the file has too many elements; expected at most {0}"),
    /** The elements are nested too deep. */
    TOO_DEEP("the elements are nested too deep; expected at most {0}"),
    /** Two elements have the same id. */
    DUPLICATE_ID("id of <{0}> is \"{1}\", which the element in line {2} already has; expected unique ids"),
    /** Two settings of a controller have the same name. */
    DUPLICATE_SETTING("name of <setting> is \"{0}\", which another <setting> has; expected unique names"),
    /** The world has too many obstacles and points. */
    TOO_MANY_PARTS("<world> has too many obstacles and points; expected at most {0} in total"),
    /** The robot has too many sensors. */
    TOO_MANY_SENSORS("<robot> has too many sensors; expected at most {0}"),
    /** An obstacle has the id of the enclosing wall. */
    RESERVED_ID("id of <{0}> is \"{1}\"; expected another id, because this is the name of the wall around the world"),
    /** Too many obstacles move. */
    TOO_MANY_MOVING("<{0}> \"{1}\" is moving obstacle number {2}; expected at most {3} (maxMoving of <world>)"),
    /** The file is not in the encoding that it names. */
    ENCODING("the bytes are not text in the encoding that the file names; expected UTF-8"),
    /** The encoding that the file names is unknown. */
    UNKNOWN_ENCODING("the file names the encoding {0}, which is not supported; expected UTF-8"),
    /** The file names no encoding, and is not in the usual one. */
    NOT_UTF8("the bytes are not text in UTF-8, and the file names no other encoding"),
    /** The XML parser failed for another reason. */
    UNREADABLE_XML("this cannot be read as XML"),
    /** The file has a document type declaration. */
    DOCTYPE("this has a DOCTYPE; expected none"),
    /** The file exceeds a limit of the XML parser. */
    PARSER_LIMIT("this exceeds a limit of the XML parser"),
    /** The file is not XML. */
    NOT_XML("this is not XML; expected a document that begins with <{0}>"),
    /** The file is not XML after a certain text. */
    NOT_XML_AFTER("this is not XML; expected a document that begins with <{0}>, after \"{1}\""),
    /** The XML is not well-formed. */
    MALFORMED("this is not well-formed XML"),
    /** The XML is not well-formed after a certain text. */
    MALFORMED_AFTER("this is not well-formed XML, after \"{0}\""),
    /** Something follows the root element. */
    AFTER_ROOT("there is text after the end of <{0}>; expected the end of the file"),
    /** The XML is not well-formed inside an element. */
    MALFORMED_INSIDE("this is not well-formed XML, inside <{0}> of line {1}"),
    /** The XML is not well-formed after a certain text inside an element. */
    MALFORMED_AFTER_INSIDE("this is not well-formed XML, after \"{0}\", inside <{1}> of line {2}"),
    /** The file does not exist. */
    NO_SUCH_FILE("there is no such file"),
    /** No file can have the name. */
    BAD_FILE_NAME("this cannot be the name of a file"),
    /** No file can have the name in the encoding of the locale. */
    UNENCODABLE_FILE_NAME("this cannot be the name of a file in the encoding of this locale, {0};"
            + " it may be possible with LC_ALL=C.UTF-8"),
    /** The file cannot be read. */
    UNREADABLE_FILE("the file cannot be read"),
    /** The path is a folder. */
    FOLDER("this is a folder; expected a {0}"),
    /** The path is neither a regular file nor a folder. */
    IRREGULAR_FILE("this is not a regular file; expected a {0}"),
    /** The file is too large. */
    TOO_MANY_BYTES("the file has {0}; expected at most {1}"),
    /** No scenario of that name is part of the program. */
    NOT_SHIPPED("the program contains no such scenario"),
    /** A scenario that is part of the program cannot be read. */
    UNREADABLE_RESOURCE("the scenario cannot be read from the program''s own files"),
    /** The file is empty. */
    EMPTY_FILE("the file is empty; expected a scenario"),
    /** There are more problems than are listed. */
    MORE("more problems: {0}"),
    /** The scenario cannot be saved. */
    NOT_SAVED("the scenario cannot be saved: {0}"),
    /** Reading the written file would give a different scenario. */
    NOT_REPRODUCIBLE("reading the saved file would give a different scenario");

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
