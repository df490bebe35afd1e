package faultline.campaign.plan;

import faultline.io.Message;
import faultline.io.MessageText;

/** A problem of a plan, besides the problems of any XML file, with its English text. */
public enum PlanProblem implements Message.Template {
    /** The file is no plan. */
    ROOT("the root element is <{0}>; expected <campaign xmlns=\"{1}\">"),
    /** The file is empty. */
    EMPTY("the file is empty; expected a campaign plan"),
    /** Two columns have the same name. */
    DUPLICATE_COLUMN("two columns of runs.csv would have the name \"{0}\"; expected unique names"
            + " (set another with the attribute name)"),
    /** Two elements set the same attribute. */
    DUPLICATE_ATTRIBUTE("the attribute \"{0}\" is set twice; expected one element that sets it"),
    /** The plan has too many runs. */
    TOO_MANY_RUNS("the plan has {0} runs; expected {1} or fewer"),
    /** An element of faults is empty. */
    NO_FAULT("<faults> contains no fault; expected one or more <fault> or <healthy>"),
    /** An element of variants is empty. */
    NO_VARIANT("<variants> contains no variant; expected one or more"),
    /** The plan has no worlds. */
    NO_WORLDS("<campaign> has no worlds; expected <worlds> with <scenario> or <rooms> in it"),
    /** Two scenarios have the same name. */
    DUPLICATE_SCENARIO("name of <scenario> is \"{0}\", which another scenario already has; expected unique names"),
    /** Two scenarios have the same file. */
    DUPLICATE_FILE("file of <scenario> is \"{0}\", which another scenario already has; expected each file once"),
    /** A room is there twice. */
    DUPLICATE_ROOM("<rooms> contains the world \"{0}\", which is there already; expected each world once"),
    /** A fault is there twice. */
    DUPLICATE_FAULT("<{0}> is the same as an earlier one; expected each fault once"),
    /** The end of a fault is given twice. */
    LASTS_AND_UNTIL("<fault> has both lasts and until; expected one of them"),
    /** A problem with the end of a fault that the plan gives by its duration. */
    LASTS("lasts of <fault> gives its end: {0}"),
    /** A scenario has a problem. */
    SCENARIO("file of <scenario> is \"{0}\": {1}"),
    /** A place in a scenario, and its problem. */
    IN_FILE("{0}: {1}"),
    /** A path leads to no element. */
    NO_SUCH_ATTRIBUTE("attribute of <set> is \"{0}\", but {1}"),
    /** A path leads to one of several elements, which is no error. */
    FIRST_ONLY("\"{0}\" sets only the first of {1} elements <{2}>; \"{3}\" names one of them, by its id or number"),
    /** The controller would have to be chosen. */
    EXTERN("the controller is from outside, which no plan can name; expected one of the program or of --jar"),
    /** A problem that a change of the plan causes in a world. */
    IN_WORLD("{0} (in {1})");

    private final String english;

    PlanProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "planProblem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
