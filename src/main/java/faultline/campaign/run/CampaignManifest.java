package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.engine.ControllerProviders;
import faultline.io.JsonWriter;
import faultline.io.ProgramVersion;
import faultline.io.Sha256;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The text of {@code campaign.json}: the plan, the program, and the meaning of the columns of the tables. Each member
 * is on a separate line, so that two campaigns can be compared line by line.
 */
final class CampaignManifest {

    private static final String JAVA = "  \"java\": ";
    private static final String CONTROLLERS = "  \"controllers\": ";
    private static final String JAR_HASH = "\"jar_sha256\": ";
    private static final String SHARD = "  \"shard\": ";
    private static final Pattern SHARD_LINE = Pattern.compile("\"shard\": \"(\\d+/\\d+)\"");

    private CampaignManifest() {}

    /** Returns the manifest of a part of a campaign. Throws an exception if the jar of a controller cannot be read. */
    static String text(CampaignPlan plan, Shard shard) throws IOException {
        List<String> lines = new ArrayList<>();
        lines.add("  \"format\": \"faultline-campaign-1\"");
        lines.add("  \"program\": " + JsonWriter.quoted(ProgramVersion.text()));
        lines.add("  \"program_sha256\": " + JsonWriter.quoted(programHash()));
        lines.add(JAVA + JsonWriter.quoted(Runtime.version().toString()));
        lines.add("  \"name\": " + JsonWriter.quoted(plan.header().name()));
        lines.add("  \"description\": " + JsonWriter.quoted(plan.header().description()));
        lines.add("  \"plan_sha256\": "
                + JsonWriter.quoted(Sha256.hex(plan.files().plan())));
        lines.add("  \"scenarios\": " + scenarios(plan.files().scenarios()));
        List<String> controllers = controllers();
        if (!controllers.isEmpty()) {
            lines.add(CONTROLLERS + array(controllers));
        }
        lines.add("  \"worlds\": " + plan.worldCount());
        lines.add("  \"seeds\": " + plan.seedCount());
        lines.add("  \"cells\": " + plan.cellCount());
        lines.add("  \"runs\": " + plan.runCount());
        lines.add(SHARD + JsonWriter.quoted(shard.toString()));
        lines.add("  \"columns\": " + columns(ResultColumns.of(plan)));
        lines.add("  \"timing_columns\": " + columns(RunTable.TIMING_COLUMNS));
        return "{\n" + String.join(",\n", lines) + "\n}\n";
    }

    /** Returns the manifest of the whole campaign, given that of a part. */
    static String ofWhole(String part) {
        return SHARD_LINE.matcher(part).replaceFirst("\"shard\": \"" + Shard.ALL + "\"");
    }

    /**
     * Returns whether two manifests belong to the same campaign, program and controllers; parts and Java versions may
     * differ.
     */
    static boolean sameCampaign(String one, String other) {
        return comparable(one).equals(comparable(other));
    }

    /**
     * Returns whether two manifests belong to the same campaign, program and controllers, of which only some are used;
     * the jars of others may differ.
     */
    static boolean sameRuns(String one, String other, List<String> used) {
        return withControllers(one, used).equals(withControllers(other, used));
    }

    private static List<String> withControllers(String manifest, List<String> used) {
        return comparable(manifest).stream()
                .filter(line -> !line.equals(CONTROLLERS + "[") && !line.equals("  ],"))
                .filter(line -> !line.contains(JAR_HASH)
                        || used.stream().anyMatch(name -> line.contains("{\"name\": " + JsonWriter.quoted(name) + ",")))
                .map(line -> line.replaceFirst(",$", ""))
                .toList();
    }

    private static List<String> comparable(String manifest) {
        return manifest.lines()
                .filter(line -> !line.startsWith(JAVA) && !line.startsWith(SHARD))
                .toList();
    }

    /** Returns the part of a manifest, empty if it states none. */
    static Optional<Shard> shard(String manifest) {
        Matcher line = SHARD_LINE.matcher(manifest);
        return line.find() ? Shard.parse(line.group(1)) : Optional.empty();
    }

    /** Returns an object for each controller from a jar. The place of the jar may differ between two parts. */
    private static List<String> controllers() throws IOException {
        List<String> objects = new ArrayList<>();
        for (Map.Entry<String, Path> jar : ControllerProviders.jars().entrySet()) {
            objects.add("    {\"name\": " + JsonWriter.quoted(jar.getKey()) + ", " + JAR_HASH
                    + JsonWriter.quoted(Sha256.hex(Files.readAllBytes(jar.getValue()))) + "}");
        }
        return objects;
    }

    private static String scenarios(Map<String, byte[]> scenarios) {
        List<String> objects = new ArrayList<>();
        scenarios.forEach((name, bytes) -> objects.add("    {\"file\": " + JsonWriter.quoted(name) + ", \"sha256\": "
                + JsonWriter.quoted(Sha256.hex(bytes)) + "}"));
        return array(objects);
    }

    private static String columns(List<Column> columns) {
        return array(columns.stream()
                .map(column -> "    {\"name\": " + JsonWriter.quoted(column.name()) + ", \"unit\": "
                        + JsonWriter.quoted(column.unit()) + ", \"meaning\": " + JsonWriter.quoted(column.meaning())
                        + "}")
                .toList());
    }

    private static String array(List<String> objects) {
        return objects.isEmpty() ? "[]" : "[\n" + String.join(",\n", objects) + "\n  ]";
    }

    /** Returns the hash of the program's jar, empty if it does not run from one. */
    private static String programHash() {
        try {
            Path program = Path.of(CampaignManifest.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            return Files.isRegularFile(program) ? Sha256.hex(Files.readAllBytes(program)) : "";
        } catch (URISyntaxException | IOException e) {
            return "";
        }
    }
}
