package faultline.app;

import faultline.external.PythonCommand;
import faultline.io.ProgramCommand;
import java.util.Arrays;

/** The output of {@code --help}. */
final class HelpText {

    private static final String HELP =
            """
            Faultline: a wall-following robot whose infrared sensors fail.

            faultline [FILE]               open the window, with a scenario file or the default scenario
              --controller WHICH           driven by a child process, such as "python3 my.py", or one in Java
              --ghost-controller WHICH     with a ghost beside it that another controller drives
              --jar FILE.jar               find controllers in Java in this file as well

            faultline run FILE [OPTION]... run a scenario without a window and print its summary
              --until S                    for S seconds in place of the file's duration
              --seed N                     with seed N in place of the file's
              --threads controller|none    the controller on its own thread, or called directly (default: none);
                                           the trajectory is the same
              --trace OUT.csv              write one row for every tick; OUT.csv.gz is compressed
              --trace-format 1|2           2 adds volts, telemetry, faults, health and OUT.csv.json (default: 1)
              --image OUT.png              write a picture of the end of the run; OUT.svg is a drawing
              --journal OUT.xml            write the scenario that replays this run
              --film OUT.gif               write a film of the run
              --pace X                     at X times real time (default: as fast as possible)
              --json                       print the summary as one JSON object
              --controller WHICH           with a controller in a child process, such as "python3 my.py", or one in Java
              --jar FILE.jar               find controllers in Java in this file as well
              --patience S|none            how many seconds a child may take to answer (default: 10)
              --truth                      give it the ground truth as well

            faultline check FILE...        report everything that is wrong with scenario files and plans of campaigns
              --jar FILE.jar               find controllers in Java in this file as well

            faultline compare FILE --controller A --controller B... --out FILE.html
                                           run each controller in the scenario; make a table and a page
              --seeds N                    with N seeds from the file's on (default: 1)
              --until, --jar, --patience, --truth   as for run
              --open                       show the first two in the window, the second as a ghost

            faultline serve FILE           step a scenario from outside, over standard input and output
              --truth, --jar               as for run

            faultline controller FILE      act as the child of --controller, with the controller of a scenario
              --jar                        as for run

            faultline import MAP --out FILE
                                           make a scenario from a floor plan: a map_server YAML file or an image
              --resolution M               the side of a pixel in metres, for an image
              --threshold P                the darkness from which a pixel of an image is solid, 0 to 1 (default: 0.65)
              --negate                     light pixels of an image are solid, from this brightness
              --unknown free|wall          what unknown cells are (default: free)
              --min-cells N                drop groups of fewer solid cells
              --smooth CELLS               straighten outlines by up to this (default: 0, exact)
              --start X,Y,HEADING          where the robot starts, from the lower left corner, metres and degrees
                                           (default: the largest free disc)

            faultline campaign PLAN --out DIR
                                           make all runs of a campaign plan, one row each in DIR/runs.csv
              --jobs N                     on N threads (default: one for each processor)
              --shard I/N                  only the I-th of N parts
              --resume                     continue the campaign in DIR, if there is one
              --jar FILE.jar               find controllers in Java in this file as well

            faultline merge DIR... --out DIR
                                           put the parts of a campaign together
              --jar                        as for campaign

            faultline report DIR --out FILE.html
                                           make a page of a campaign, with intervals and differences
              --table FILE.csv             write the numbers of its cells as well
              --jar                        as for campaign

            faultline figures --out DIR    make the paper's figures and the studies behind its claims
              --theme light|dark|adaptive  their colours; adaptive follows the reader's screen (default: adaptive)

            faultline --window [FILE]      open the window as a desktop does, where problems of the file are shown

            faultline --startup-time [FILE]
                                           open the window, print how long that took, and close it

            faultline help [COMMAND]       show this help, or only that of a command; as --help, -h or COMMAND --help
            faultline --version            show the version

            Exit codes: 0 done and every expectation held, 1 an expectation failed, 2 bad usage or a bad file, 3 the run broke.""";

    private HelpText() {}

    /** Returns the help of all commands. */
    static String help() {
        return withMeaningOfName(HELP);
    }

    /** Returns the paragraph about a command, or the help of all commands if it has none. */
    static String help(String command) {
        return Arrays.stream(HELP.split("\n\n"))
                .filter(paragraph -> paragraph.startsWith("faultline " + command + " "))
                .findFirst()
                .map(HelpText::withMeaningOfName)
                .orElseGet(HelpText::help);
    }

    /**
     * Adds what the name of the program stands for, if it is not a command itself. Python has its name of this system.
     */
    private static String withMeaningOfName(String help) {
        String command = ProgramCommand.text();
        return help.replace("python3", PythonCommand.text())
                + (command.equals("faultline") ? "" : "\n\n\"faultline\" stands for: " + command);
    }
}
