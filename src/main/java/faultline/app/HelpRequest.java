package faultline.app;

import java.util.List;

/** Thrown if the arguments of a command ask for its help. The message is for a place that has no help of its own. */
final class HelpRequest extends UsageException {

    private static final long serialVersionUID = 1L;

    private HelpRequest(String option) {
        super(option + " follows a command, not a file");
    }

    /** Returns whether an argument is an option that asks for help. */
    static boolean isHelp(String argument) {
        return argument.equals(CommandLine.HELP) || argument.equals(CommandLine.SHORT_HELP);
    }

    /**
     * Throws this if an argument asks for help, whatever is wrong with the others. What follows an option that takes a
     * value stands for the value.
     */
    static void throwIfIn(List<String> arguments, List<String> withValue) throws HelpRequest {
        for (int i = 0; i < arguments.size(); i += withValue.contains(arguments.get(i)) ? 2 : 1) {
            if (isHelp(arguments.get(i))) {
                throw new HelpRequest(arguments.get(i));
            }
        }
    }
}
