package faultline.external;

import faultline.io.Message;
import faultline.io.MessageText;

/**
 * The problems of a controller in another process, with the English text of each. In a sentence, <code>{0}</code> is
 * the other side, and <code>{1}</code> is the time, which begins with a blank or is empty.
 */
public enum ControllerProblem implements Message.Template {
    /** The controller of a command. */
    CONTROLLER("the controller \"{0}\""),
    /** A time during the run. */
    AT_TICK(" at tick {0}"),
    /** The time before the run. */
    BEFORE_START(" before the first tick"),
    /** A sentence in other words, which are not translated. */
    OTHER("{0} {2}{1}{3}"),
    /** The streams of the child are broken. */
    UNREADABLE("{0} cannot be read{1}: {2}"),
    /** A sentence with the standard error of the child. */
    LAST_LINE("{0}; its last line on standard error: {1}"),
    /** The last line of a traceback, with a file and a line of the program. */
    AT_LINE("{0} ({1}, line {2})"),
    /** The last of several lines that follow the traceback of an exception. */
    AFTER_EXCEPTION("{0}, after the exception {1}"),
    /** A sentence with several lines of the standard error of the child. */
    LAST_LINES("{0}; its last line on standard error: {1}; the lines before: {2}"),

    /** The child cannot be started, with the reason and a hint. */
    NOT_STARTED("{0} cannot be started: {1}{2}"),
    /** The command has no word. */
    EMPTY_COMMAND("the command is empty"),
    /** The command has no second quote. */
    OPEN_QUOTE("a quote is not closed"),
    /** The program does not exist. */
    NO_PROGRAM("there is no such program"),
    /** The interpreter of a script does not exist. */
    NO_INTERPRETER("the interpreter that its first line names does not exist"),
    /** The file may not be executed. */
    NOT_EXECUTABLE("the file is not executable"),
    /** The path is a folder. */
    FOLDER("this is a folder; expected a program"),
    /** The file cannot be executed. */
    NOT_A_PROGRAM("the file is not a program"),
    /** A reason with the usual name of Python. */
    USUAL_PYTHON("{0}; Python is usually started by \"{1}\""),
    /** A reason with the command that starts a script. */
    PYTHON_SCRIPT("{0}; a program in Python is started by \"{1} {2}\""),
    /** A reason with the way to use a jar. */
    JAR("{0}; the controllers of a jar are added with --jar or in the window with \"File\", and chosen by name"),
    /** A jar that does not exist. */
    NO_JAR("there is no jar {0}"),
    /** A jar that is broken. */
    JAR_UNREADABLE("the jar {0} cannot be read: {1}"),
    /** A jar whose controllers cannot be found. */
    NO_SERVICE("the jar {0} has no controller, because it has no file {1}, which contains the full name of the"
            + " controller''s class"),
    /** A jar whose file for controllers names none. */
    NO_NAMED_CLASS("the jar {0} has no controller, because its file {1} names no class of one; expected the full name"
            + " of the controller''s class"),
    /** The hint for a command that is the name of a file with blanks. */
    UNQUOTED("; a path with blanks is one word in quotes: {0}"),
    /** The hint for a misspelt name. */
    NAMES("; names of controllers are {0}"),

    /** The child has ended. */
    ENDED("{0} ended with exit code {2}{1}{3}"),
    /** The program was ended, for example by a signal, and has ended the child. */
    ENDED_WITH_PROGRAM("{0} was ended with the program{1}"),
    /** The child has closed its input. */
    CLOSED_INPUT("{0} closed its standard input{1}"),
    /** The child has closed its output. */
    CLOSED_OUTPUT("{0} closed its standard output{1}{2}"),
    /** The place of an end within a line. */
    IN_LINE(" in the middle of a line"),
    /** The hint for a child that has ended as if all were well. */
    UNTIL_END("; it must answer until the run has ended, as drive_with of the Python client does"),
    /** The child does not read. */
    NOT_READING("{0} does not read its standard input{1}"),
    /** The child does not answer. */
    SILENT("{0} has not answered for {2} s{1}{3}"),
    /** The answer has only begun. */
    OPEN_LINE("; its last line has no end"),
    /** The hint for a child that has never answered. */
    UNFLUSHED("; a program must flush its standard output after each line"),

    /** Another version of the protocol. */
    PROTOCOL("{0} speaks protocol {2}{1}; expected {3}"),
    /** A message of another type. */
    TYPE("{0} wrote a message{1} of type {2}; expected \"{3}\""),
    /** An answer for another tick. */
    TICK("{0} answered tick {2}{1}; expected the tick of the observation"),
    /** An answer to an observation that has not been sent. */
    EARLY_ANSWER("{0} answered{1} before the observation was sent; expected an answer to each observation"),
    /** An answer that was not asked for. */
    EXTRA_ANSWER("{0} answered more often than it was asked{1}; expected one answer for each observation"),
    /** A line that is too long. */
    LONG_LINE("{0} wrote a line of more than {2} bytes{1}; expected shorter ones"),
    /** A line in another encoding. */
    NOT_UTF8("{0} wrote a line{1} that is not UTF-8: {2}"),
    /** A line that is not JSON. */
    NO_JSON("{0} wrote no JSON{1}: {2} ({3}); write messages for people to standard error"),
    /** A line that is not an object. */
    NO_OBJECT("{0} wrote no JSON object{1}: {2}"),
    /** A wrong member of a message. */
    MEMBER("{0} wrote a message{1} whose {2} is {3}; expected {4}"),
    /** Both kinds of members of a decision. */
    BOTH_DRIVES("{0} wrote a drive message{1} with voltages and velocities; expected either left_v and right_v or v_m_s"
            + " and omega_rad_s"),
    /** No kind of members of a decision. */
    NO_DRIVE("{0} wrote a drive message{1} with neither voltages nor velocities; expected either left_v and right_v or"
            + " v_m_s and omega_rad_s"),
    /** Velocities that need infinite voltages. */
    TOO_FAST("{0} wrote a drive message{1} whose velocities are too large for any voltage"),

    /** The value of a member that does not exist. */
    MISSING("missing"),
    /** The value of a member that is a string. */
    GIVEN_STRING("the string {0}"),
    /** The value of a member that is a number. */
    GIVEN_NUMBER("the number {0}"),
    /** The value of a member that is an array. */
    GIVEN_ARRAY("the array {0}"),
    /** The value of a member that is an object. */
    GIVEN_OBJECT("the object {0}"),
    /** A string is expected. */
    STRING("a string"),
    /** A number is expected. */
    NUMBER("a finite number"),
    /** A whole number is expected. */
    WHOLE("a whole number"),
    /** A whole number of a type is expected. */
    WHOLE_FROM("a whole number from {0} to {1}, without point and exponent if it has more than 15 digits"),
    /** An object is expected. */
    OBJECT("an object"),
    /** Several objects are expected. */
    OBJECTS("an array of objects"),
    /** Several numbers are expected. */
    NUMBERS("an array of finite numbers"),
    /** Several truth values are expected. */
    FLAGS("an array of true and false");

    private final String english;

    ControllerProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "controllerProblem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
