package faultline.app;

import faultline.external.BuiltInChild;
import faultline.external.SimulationServer;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.List;

/** {@code serve} and {@code controller}: speak the protocol of controllers over standard input and output. */
final class ProtocolCommands {

    private final CommandOutput output;

    ProtocolCommands(CommandOutput output) {
        this.output = output;
    }

    /** Steps a scenario from outside. */
    int serve(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments sorted = new Arguments(arguments, List.of(), List.of("--truth"));
        Scenario scenario = Scenario.load(sorted.singleFile("serve"));
        new SimulationServer(HelpText.version(), scenario.name(), sorted.has("--truth"), System.in, output.out())
                .run(scenario.setup());
        return ExitCode.SUCCESS;
    }

    /** Acts as the child of another simulator, with the built-in controller of a scenario. */
    int controller(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Scenario scenario = Scenario.load(new Arguments(arguments, List.of()).singleFile("controller"));
        new BuiltInChild(System.in, output.out()).run(scenario.setup().controller());
        return ExitCode.SUCCESS;
    }
}
