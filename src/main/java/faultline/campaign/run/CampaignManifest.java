package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.engine.ControllerProviders;
import faultline.io.JsonException;
import faultline.io.JsonParser;
import faultline.io.JsonWriter;
import faultline.io.ProgramFile;
import faultline.io.ProgramVersion;
import faultline.io.Sha256;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The contents of {@code campaign.json}: the plan, the program, and the meaning of the columns of the tables.
 *
 * @param members the members in order, as {@link JsonParser} reads them; none if the file has other contents
 */
record CampaignManifest(Map<String, Object> members) {

    private static final String JAVA = "java";
    private static final String CONTROLLERS = "controllers";
    private static final String NAME = "name";
    private static final String SHARD = "shard";
    private static final String COLUMNS = "columns";
    private static final String TIMING_COLUMNS = "timing_columns";

    /**
     * The members that may differ within a campaign. The plan and the program determine the columns, and the tables
     * name them, so a better description of a column makes no other campaign.
     */
    private static final List<String> NOT_COMPARED = List.of(JAVA, SHARD, COLUMNS, TIMING_COLUMNS);

    CampaignManifest {
        members = Collections.unmodifiableMap(new LinkedHashMap<>(members));
    }

    /** Returns the manifest of a part of a campaign. Throws an exception if the jar of a controller cannot be read. */
    static CampaignManifest of(CampaignPlan plan, Shard shard) throws IOException {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put("format", "faultline-campaign-1");
        members.put("program", ProgramVersion.text());
        members.put("program_sha256", programHash());
        members.put(JAVA, Runtime.version().toString());
        members.put(NAME, plan.header().name());
        members.put("description", plan.header().description());
        members.put("plan_sha256", Sha256.hex(plan.files().plan()));
        members.put("scenarios", scenarios(plan.files().scenarios()));
        List<Object> controllers = controllers();
        if (!controllers.isEmpty()) {
            members.put(CONTROLLERS, controllers);
        }
        members.put("worlds", (double) plan.worldCount());
        members.put("seeds", (double) plan.seedCount());
        members.put("cells", (double) plan.cellCount());
        members.put("runs", (double) plan.runCount());
        members.put(SHARD, shard.toString());
        members.put(COLUMNS, columns(ResultColumns.of(plan)));
        members.put(TIMING_COLUMNS, columns(RunTable.TIMING_COLUMNS));
        return new CampaignManifest(members);
    }

    /** Returns the manifest with the contents of a file, whatever they are. */
    @SuppressWarnings("unchecked")
    static CampaignManifest parse(String text) {
        try {
            return new CampaignManifest(
                    JsonParser.parse(text) instanceof Map<?, ?> members ? (Map<String, Object>) members : Map.of());
        } catch (JsonException damaged) {
            return new CampaignManifest(Map.of());
        }
    }

    /** Returns the contents of the file: a line for each member, and for each item of a list. */
    String text() {
        return members.entrySet().stream()
                .map(member -> "  " + member(member.getKey(), lines(member.getValue())))
                .collect(Collectors.joining(",\n", "{\n", "\n}\n"));
    }

    private static String member(String name, String value) {
        return JsonWriter.quoted(name) + ": " + value;
    }

    private static String lines(Object value) {
        return value instanceof List<?> items && !items.isEmpty()
                ? items.stream().map(CampaignManifest::line).collect(Collectors.joining(",\n    ", "[\n    ", "\n  ]"))
                : line(value);
    }

    private static String line(Object value) {
        if (value instanceof Map<?, ?> object) {
            return object.entrySet().stream()
                    .map(member -> member(member.getKey().toString(), line(member.getValue())))
                    .collect(Collectors.joining(", ", "{", "}"));
        }
        if (value instanceof List<?> items) {
            return items.stream().map(CampaignManifest::line).collect(Collectors.joining(", ", "[", "]"));
        }
        if (value instanceof String string) {
            return JsonWriter.quoted(string);
        }
        return value instanceof Double number && number == Math.rint(number) && Math.abs(number) < 1L << 53
                ? Long.toString(number.longValue())
                : String.valueOf(value);
    }

    /** Returns this manifest for another part of the campaign. */
    CampaignManifest with(Shard shard) {
        Map<String, Object> changed = new LinkedHashMap<>(members);
        changed.put(SHARD, shard.toString());
        return new CampaignManifest(changed);
    }

    /**
     * Returns whether another manifest belongs to the same campaign, program and controllers; parts, Java versions and
     * descriptions of columns may differ.
     */
    boolean isSameCampaign(CampaignManifest other) {
        return comparable().equals(other.comparable());
    }

    /**
     * Returns whether another manifest belongs to the same campaign, program and controllers, of which only some are
     * used; the jars of others may differ.
     */
    boolean hasSameRuns(CampaignManifest other, Collection<String> used) {
        return comparable(used).equals(other.comparable(used));
    }

    private Map<String, Object> comparable() {
        Map<String, Object> comparable = new LinkedHashMap<>(members);
        NOT_COMPARED.forEach(comparable::remove);
        return comparable;
    }

    private Map<String, Object> comparable(Collection<String> used) {
        Map<String, Object> comparable = comparable();
        List<Object> all = members.get(CONTROLLERS) instanceof List<?> listed ? new ArrayList<>(listed) : List.of();
        comparable.put(
                CONTROLLERS,
                all.stream()
                        .filter(jar -> jar instanceof Map<?, ?> object && used.contains(object.get(NAME)))
                        .toList());
        return comparable;
    }

    /** Returns the part, empty if the manifest states none. */
    Optional<Shard> shard() {
        return members.get(SHARD) instanceof String text ? Shard.parse(text) : Optional.empty();
    }

    /** Returns an object for each controller from a jar. The place of the jar may differ between two parts. */
    private static List<Object> controllers() throws IOException {
        List<Object> objects = new ArrayList<>();
        for (Map.Entry<String, Path> jar : ControllerProviders.jars().entrySet()) {
            Map<String, Object> object = new LinkedHashMap<>();
            object.put(NAME, jar.getKey());
            object.put("jar_sha256", Sha256.hex(Files.readAllBytes(jar.getValue())));
            objects.add(object);
        }
        return objects;
    }

    private static List<Object> scenarios(Map<String, byte[]> scenarios) {
        List<Object> objects = new ArrayList<>();
        scenarios.forEach((name, bytes) -> {
            Map<String, Object> object = new LinkedHashMap<>();
            object.put("file", name);
            object.put("sha256", Sha256.hex(bytes));
            objects.add(object);
        });
        return objects;
    }

    private static List<Object> columns(List<Column> columns) {
        List<Object> objects = new ArrayList<>();
        for (Column column : columns) {
            Map<String, Object> object = new LinkedHashMap<>();
            object.put(NAME, column.name());
            object.put("unit", column.unit());
            object.put("meaning", column.meaning());
            objects.add(object);
        }
        return objects;
    }

    /** Returns the hash of the program's jar, empty if it does not run from one. */
    private static String programHash() {
        try {
            Optional<Path> program = ProgramFile.find().filter(Files::isRegularFile);
            return program.isPresent() ? Sha256.hex(Files.readAllBytes(program.get())) : "";
        } catch (IOException e) {
            return "";
        }
    }
}
