package faultline.campaign.plan;

import faultline.io.Message;
import faultline.io.MessageText;

/** A problem of a plan, besides the problems of any XML file, with its English text. */
enum PlanProblem implements Message.Template {
    ROOT("the root element is <{0}>; expected <campaign xmlns=\"{1}\">"),
    DUPLICATE_COLUMN("two columns of runs.csv would have the name \"{0}\"; expected unique names"
            + " (set another with the attribute name)"),
    DUPLICATE_ATTRIBUTE("the attribute \"{0}\" is set twice; expected one element that sets it"),
    TOO_MANY_RUNS("the plan has {0} runs; expected {1} or fewer"),
    NO_FAULT("<faults> contains no fault; expected one or more <fault> or <healthy>"),
    NO_VARIANT("<variants> contains no variant; expected one or more"),
    NO_WORLDS("<campaign> has no worlds; expected <worlds> with <scenario> or <rooms> in it"),
    DUPLICATE_SCENARIO(
            "name of <scenario> is \"{0}\", which another scenario already has;" + " expected unique names and files"),
    DUPLICATE_ROOM("<rooms> contains the world \"{0}\", which is there already; expected each world once"),
    DUPLICATE_FAULT("<{0}> is the same as an earlier one; expected each fault once"),
    LASTS_AND_UNTIL("<fault> has both lasts and until; expected one of them"),
    SCENARIO("file of <scenario> is \"{0}\": {1}"),
    NO_SUCH_ATTRIBUTE("attribute of <set> is \"{0}\", but {1}"),
    EXTERN("the controller is from outside, which no plan can name; expected one of the program or of --jar"),
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
