package faultline.app;

import faultline.external.BuiltInChild;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.List;

/** {@code controller}: acts as the child of another simulator, with the built-in controller of a scenario. */
final class ControllerCommand {

    private final CommandOutput output;

    ControllerCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments sorted = new Arguments(arguments, List.of());
        Scenario scenario = Scenario.load(sorted.singleFile("controller"));
        new BuiltInChild(System.in, output.out()).run(scenario.setup().controller());
        return ExitCode.SUCCESS;
    }
}
