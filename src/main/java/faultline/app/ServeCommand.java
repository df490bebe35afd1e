package faultline.app;

import faultline.external.Server;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.List;

/** {@code serve}: steps a scenario from outside, over standard input and output. */
final class ServeCommand {

    private final CommandOutput output;

    ServeCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments sorted = new Arguments(arguments, List.of(), List.of("--truth"));
        Scenario scenario = Scenario.load(sorted.singleFile("serve"));
        new Server(HelpText.version(), scenario.name(), sorted.has("--truth"), System.in, output.out())
                .run(scenario.setup());
        return ExitCode.SUCCESS;
    }
}
