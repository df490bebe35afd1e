package faultline.engine;

import faultline.io.Message;
import faultline.io.MessageText;

/** The reasons why a run cannot start or continue, with the English text of each. */
public enum RunProblem implements Message.Template {
    /** A reason in other words, which are not translated. */
    OTHER("{0}"),
    /** An internal error. */
    RUN_BROKE("the run broke at tick {0}: {1}"),
    /** The run was interrupted. */
    INTERRUPTED("the run was interrupted at tick {0}"),
    /** A record of decisions is shorter than the run that repeats it. */
    RECORD_ENDED("the record of decisions ends after tick {0}"),
    /** The contacts of the robot in a tick cannot be found. */
    UNRESOLVED_CONTACT("tick {0}: {1}"),
    /** The controller threw an exception. */
    CONTROLLER_BROKE("the controller broke at tick {0}: {1}"),
    /** The controller does not answer. */
    NO_ANSWER("the controller has not answered for {0} s at tick {1}"),
    /** The controller does not answer, and its thread does not end. */
    NO_END("the controller has not answered for {0} s at tick {1}; it ignores interruption, so its thread continues"
            + " until the program ends"),
    /** No controller was chosen for a scenario that needs one. */
    NOT_CHOSEN("the scenario is driven by a controller from outside, and none was chosen"),
    /** A controller in Java does not exist. */
    NO_CONTROLLER("there is no controller \"{0}\""),
    /** A controller in Java cannot be created. */
    NOT_CREATED("the controller \"{0}\" cannot be created: {1}"),
    /** A controller threw an exception when it was closed. */
    NOT_CLOSED("the controller cannot be closed: {0}"),
    /** A class of a controller in Java cannot be loaded. */
    NOT_LOADED("a controller in Java cannot be loaded: {0}"),
    /** A class of a controller in Java does not exist. */
    NO_CLASS("a controller in Java cannot be loaded: there is no class {0}, which a file META-INF/services/{1} names;"
            + " expected the full name of a class"),
    /** A class of a controller in Java is too new. */
    NEWER_JAVA("a controller in Java cannot be loaded: {0} was compiled for Java {1}, but Java {2} runs it; compile it"
            + " with --release {2}"),
    /** A class that is no provider. */
    NO_PROVIDER("a controller in Java cannot be loaded: the class {0}, which a file META-INF/services/{1} names, does"
            + " not implement {1}"),
    /** A class of a controller in Java that the program must not create. */
    NO_CONSTRUCTOR("a controller in Java cannot be loaded: the class {0} is not public, or has no public constructor"
            + " without parameters"),
    /** A class of a controller in Java that has no objects. */
    ABSTRACT_CLASS("a controller in Java cannot be loaded: the class {0} is abstract"),
    /** A controller in Java has no name. */
    NAMELESS("the controller in Java {0} has no name: {1}"),
    /** A controller in Java has the name of a built-in one. */
    BUILT_IN_NAME("the controller in Java {0} has the name of a built-in one: {1}"),
    /** Two controllers in Java have the same name. */
    SAME_NAME("the controllers in Java {0} and {1} have the same name: {2}");

    private final String english;

    RunProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "runProblem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
