package faultline.app;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.control.ControllerSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.ScenarioException;
import java.nio.file.Path;
import java.util.List;

/** {@code check}: reads scenario files and reports their problems. */
final class CheckCommand {

    private final CommandOutput output;

    CheckCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException {
        Arguments given = new Arguments(arguments, List.of("--jar"));
        List<String> files = given.files();
        if (files.isEmpty()) {
            throw new UsageException("check takes one or more scenario files or plans, not none");
        }
        ControllerOptions.addJar(given);
        int code = ExitCode.SUCCESS;
        for (String file : files) {
            code = Math.max(code, checkFile(file));
        }
        return code;
    }

    /** Throws an exception if every run of a scenario breaks at its start, although the file can be read. */
    private static void requireRecord(Path file, Scenario scenario) throws ScenarioException {
        if (scenario.setup().controller() instanceof ControllerSpec.Recorded record
                && record.ticks() == 0
                && scenario.setup().ticks() > 0) {
            throw new ScenarioException(
                    file.toString(), ProblemKind.VALUE.with("ticks", "controller", 0, Allowed.RECORDED_TICKS.with()));
        }
    }

    private int checkFile(String file) {
        try {
            Path path = Arguments.parsePath(file);
            if (PlanFiles.isPlan(path)) {
                CampaignPlan plan = PlanFiles.read(path);
                output.printNotes(plan.notes());
                output.println(file + ": good, " + plan.runCount() + (plan.runCount() == 1 ? " run" : " runs"));
            } else {
                requireRecord(path, Scenario.load(path));
                output.println(file + ": good");
            }
            return ExitCode.SUCCESS;
        } catch (UsageException e) {
            // The name cannot be that of a file, which is no reason to keep the problems of the others back.
            output.printError(e.getMessage());
            return ExitCode.BAD_INPUT;
        } catch (ScenarioException e) {
            output.printError(e);
            return ExitCode.BAD_INPUT;
        }
    }
}
