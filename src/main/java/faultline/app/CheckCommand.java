package faultline.app;

import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.util.List;

/** {@code check}: reads scenario files and tells what is wrong with them. */
final class CheckCommand {

    private final Console console;

    CheckCommand(Console console) {
        this.console = console;
    }

    int run(List<String> arguments) throws UsageException {
        List<String> files = new Arguments(arguments, List.of()).files();
        if (files.isEmpty()) {
            throw new UsageException("check takes one or more scenario files, not none");
        }
        int code = ExitCode.DONE;
        for (String file : files) {
            code = Math.max(code, check(file));
        }
        return code;
    }

    private int check(String file) throws UsageException {
        try {
            Scenario.load(Arguments.path(file));
            console.tell(file + ": good");
            return ExitCode.DONE;
        } catch (ScenarioException e) {
            console.complain(e.getMessage());
            return ExitCode.BAD_INPUT;
        }
    }
}
