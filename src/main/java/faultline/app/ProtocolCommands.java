package faultline.app;

import faultline.control.ControllerSpec;
import faultline.external.BuiltInChild;
import faultline.external.SimulationServer;
import faultline.io.ProgramVersion;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** {@code serve} and {@code controller}: speak the protocol of controllers over standard input and output. */
final class ProtocolCommands {

    private final CommandOutput output;

    ProtocolCommands(CommandOutput output) {
        this.output = output;
    }

    /** Steps a scenario from outside. */
    int serve(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, List.of("--jar"), List.of("--truth"));
        Path file = parsed.singleFile("serve");
        ControllerOptions.addJar(parsed);
        Scenario scenario = Scenario.load(file);
        new SimulationServer(
                        ProgramVersion.text(),
                        scenario.name(),
                        parsed.has("--truth"),
                        StandardInput.stream(),
                        output.out())
                .run(scenario.setup(), new ClientProcess()::isGone);
        return ExitCode.SUCCESS;
    }

    /** Acts as the child of another simulator, with the controller of a scenario. */
    int controller(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, List.of("--jar"));
        Path file = parsed.singleFile("controller");
        ControllerOptions.addJar(parsed);
        Scenario scenario = Scenario.load(file);
        if (scenario.setup().controller() instanceof ControllerSpec.Extern) {
            throw new UsageException("the scenario is driven by a controller from outside;"
                    + " expected one whose controller is in the program or in --jar");
        }
        new BuiltInChild(StandardInput.stream(), output.out())
                .run(scenario.setup().controller());
        return ExitCode.SUCCESS;
    }
}
