package faultline.app;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.util.List;

/** {@code check}: reads scenario files and reports their problems. */
final class CheckCommand {

    private final CommandOutput output;

    CheckCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException {
        List<String> files = new Arguments(arguments, List.of()).files();
        if (files.isEmpty()) {
            throw new UsageException("check takes one or more scenario files, not none");
        }
        int code = ExitCode.SUCCESS;
        for (String file : files) {
            code = Math.max(code, checkFile(file));
        }
        return code;
    }

    private int checkFile(String file) throws UsageException {
        try {
            Scenario.load(Arguments.parsePath(file));
            output.println(file + ": good");
            return ExitCode.SUCCESS;
        } catch (ScenarioException e) {
            output.printError(e.getMessage());
            return ExitCode.BAD_INPUT;
        }
    }
}
