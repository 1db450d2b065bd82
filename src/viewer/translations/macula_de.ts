<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Clip</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>, values on cut faces only coarsely</source>
        <translation>, Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>, denoised</source>
        <translation>, entrauscht</translation>
    </message>
    <message>
        <source>, smoothed</source>
        <translation>, geglättet</translation>
    </message>
    <message>
        <source>, 1/%1 of the pixels each way</source>
        <translation>, 1/%1 der Pixel je Richtung</translation>
    </message>
    <message>
        <source>, %1 of %2 samples</source>
        <translation>, %1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>, complete</source>
        <translation>, vollständig</translation>
    </message>
    <message>
        <source>, converging</source>
        <translation>, wird besser</translation>
    </message>
    <message>
        <source>, parallel rays</source>
        <translation>, parallele Strahlen</translation>
    </message>
    <message>
        <source>, sharp centre traced %L1 s ago</source>
        <translation>, scharfe Mitte vor %L1 s verfolgt</translation>
    </message>
    <message numerus="yes">
        <source>Preview, sharpened in %n steps</source>
        <translation>
            <numerusform>Vorschau, in %n Schritt geschärft</numerusform>
            <numerusform>Vorschau, in %n Schritten geschärft</numerusform>
        </translation>
    </message>
    <message>
        <source>, coarse preview</source>
        <translation>, grobe Vorschau</translation>
    </message>
    <message numerus="yes">
        <source>, %n samples</source>
        <translation>
            <numerusform>, %n Abtastung</numerusform>
            <numerusform>, %n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>, preview where it is less noisy</source>
        <translation>, Vorschau, wo sie weniger rauscht</translation>
    </message>
    <message>
        <source>Preview, estimated from the values</source>
        <translation>Vorschau, aus den Werten geschätzt</translation>
    </message>
</context>
<context>
    <name>HeadsetWords</name>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Knife: on</source>
        <translation>Messer: an</translation>
    </message>
    <message>
        <source>Knife: off</source>
        <translation>Messer: aus</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>Halte: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Reset clips</source>
        <translation>Beschnitt weg</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Bild aufnehmen</translation>
    </message>
    <message>
        <source>Other wrist</source>
        <translation>Andere Hand</translation>
    </message>
    <message>
        <source>Real size 1:1</source>
        <translation>Maßstab 1:1</translation>
    </message>
    <message>
        <source>%1 times real size</source>
        <translation>%1-mal wahre Größe</translation>
    </message>
    <message>
        <source>1/%1 of real size</source>
        <translation>1/%1 der wahren Größe</translation>
    </message>
    <message>
        <source>Before me</source>
        <translation>Vor mich</translation>
    </message>
    <message>
        <source>Quality: %1</source>
        <translation>Qualität: %1</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>ausgewogen</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>Not for primary diagnosis</source>
        <translation>Nicht zur Primärdiagnose</translation>
    </message>
    <message>
        <source>Real size 1:1: a millimetre is a millimetre.</source>
        <translation>Maßstab 1:1: ein Millimeter ist ein Millimeter.</translation>
    </message>
    <message>
        <source>Before you, at real size 1:1.</source>
        <translation>Vor Ihnen, im Maßstab 1:1.</translation>
    </message>
    <message>
        <source>Nothing would be left to see: that was not done.</source>
        <translation>Es bliebe nichts zu sehen: das geschah nicht.</translation>
    </message>
    <message>
        <source>No more than six cuts: undo one, or reset the clips.</source>
        <translation>Höchstens sechs Schnitte: nehmen Sie einen zurück.</translation>
    </message>
    <message>
        <source>The headset has lost its place. Look around.</source>
        <translation>Das Headset weiß nicht, wo es ist. Sehen Sie umher.</translation>
    </message>
    <message>
        <source>Picture %1 is written.</source>
        <translation>Bild %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Size is not calibrated</source>
        <translation>Größe ist nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>About Macula</source>
        <translation>Über Macula</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Path-traced anatomy from DICOM.&lt;/p&gt;&lt;p&gt;Not a medical device, and &lt;b&gt;not for primary diagnosis&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Licence: Apache-2.0.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Pfadverfolgte Anatomie aus DICOM.&lt;/p&gt;&lt;p&gt;Kein Medizinprodukt und &lt;b&gt;nicht zur Primärdiagnose&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Lizenz: Apache-2.0.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>JoinQuestion</name>
    <message>
        <source>One series?</source>
        <translation>Eine Serie?</translation>
    </message>
    <message>
        <source> Are they one series?</source>
        <translation> Sind sie eine Serie?</translation>
    </message>
    <message>
        <source>If you join them, check that all of them are of one patient and one examination.</source>
        <translation>Wenn Sie sie verbinden, prüfen Sie, dass alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>&amp;Join Them</source>
        <translation>&amp;Verbinden</translation>
    </message>
</context>
<context>
    <name>KeyBook</name>
    <message>
        <source>Only one key at a time can be taken, with Ctrl, Shift or Alt.</source>
        <translation>Es kann nur eine Taste auf einmal sein, mit Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is used in panes, lists and fields. Take another key.</source>
        <translation>%1 wird in Bildfeldern, Listen und Feldern gebraucht. Nehmen Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>This works in the picture, with one key alone. Take one without Ctrl, Shift or Alt.</source>
        <translation>Das wirkt im Bild mit einer Taste allein. Nehmen Sie eine ohne Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. Change that one first, or take another key.</source>
        <translation>%1 ist die Taste von „%2“. Ändern Sie zuerst diese, oder nehmen Sie eine andere Taste.</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>Path traced</source>
        <translation>Pfadverfolgt</translation>
    </message>
    <message>
        <source>Path traced, clear</source>
        <translation>Pfadverfolgt, klar</translation>
    </message>
</context>
<context>
    <name>Model</name>
    <message>
        <source>It goes on from where an earlier session left it.</source>
        <translation>Es macht weiter, wo eine frühere Sitzung aufgehört hat.</translation>
    </message>
    <message>
        <source>The graphics device has no room for it beside the volume: while a hand moves, small traced pictures are shown.</source>
        <translation>Das Grafikgerät hat neben dem Volumen keinen Platz dafür: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
    <message>
        <source>It could not be made on this graphics device: while a hand moves, small traced pictures are shown.</source>
        <translation>Es konnte auf diesem Grafikgerät nicht erstellt werden: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
    <message>
        <source>Preparing the preview</source>
        <translation>Vorschau wird vorbereitet</translation>
    </message>
    <message numerus="yes">
        <source>Preview of an earlier session, %n steps</source>
        <translation>
            <numerusform>Vorschau einer früheren Sitzung, %n Schritt</numerusform>
            <numerusform>Vorschau einer früheren Sitzung, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharpening, %n steps</source>
        <translation>
            <numerusform>Vorschau wird schärfer, %n Schritt</numerusform>
            <numerusform>Vorschau wird schärfer, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview not sharp yet, %n steps</source>
        <translation>
            <numerusform>Vorschau noch unscharf, %n Schritt</numerusform>
            <numerusform>Vorschau noch unscharf, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharp, %n steps</source>
        <translation>
            <numerusform>Vorschau scharf, %n Schritt</numerusform>
            <numerusform>Vorschau scharf, %n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>No memory for a sharp preview</source>
        <translation>Kein Speicher für eine scharfe Vorschau</translation>
    </message>
    <message>
        <source>No sharp preview</source>
        <translation>Keine scharfe Vorschau</translation>
    </message>
    <message>
        <source>It began with the stored preview of other lights.</source>
        <translation>Sie hat mit der gespeicherten Vorschau einer anderen Beleuchtung begonnen.</translation>
    </message>
    <message>
        <source>It began with a preview that another version of Macula stored.</source>
        <translation>Sie hat mit einer Vorschau begonnen, die eine andere Version von Macula gespeichert hat.</translation>
    </message>
    <message>
        <source>The stored preview of this was damaged; it began anew.</source>
        <translation>Die gespeicherte Vorschau hiervon war beschädigt; sie hat neu begonnen.</translation>
    </message>
    <message>
        <source>Preview not sharp enough to be shown</source>
        <translation>Vorschau nicht scharf genug, um gezeigt zu werden</translation>
    </message>
    <message>
        <source>Preparing the preview, longer at the first start</source>
        <translation>Vorschau wird vorbereitet, beim ersten Start länger</translation>
    </message>
    <message>
        <source>At its first start Macula compiles its programs for the graphics device. Later starts find them.</source>
        <translation>Beim ersten Start übersetzt Macula seine Programme für das Grafikgerät. Spätere Starts finden sie vor.</translation>
    </message>
</context>
<context>
    <name>PaneClip</name>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
</context>
<context>
    <name>PaneMeasurements</name>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Plane alone: %1</source>
        <translation>Ebene allein: %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measurement removed</source>
        <translation>Messung entfernt</translation>
    </message>
    <message>
        <source>Measurement moved</source>
        <translation>Messung verschoben</translation>
    </message>
</context>
<context>
    <name>PaneRequest</name>
    <message>
        <source>In colours: the size of pixels is not calibrated</source>
        <translation>In Farben: Die Pixelgröße ist nicht kalibriert</translation>
    </message>
    <message>
        <source>In colours: some slices are interpolated</source>
        <translation>In Farbe: einige Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>In colours: %1</source>
        <translation>In Farben: %1</translation>
    </message>
    <message>
        <source>The size of its pixels is not calibrated</source>
        <translation>Die Größe seiner Pixel ist nicht kalibriert</translation>
    </message>
    <message>
        <source>Some of its slices are interpolated</source>
        <translation>Einige seiner Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>In the plane of the study: %1</source>
        <translation>In der Ebene der Studie: %1</translation>
    </message>
    <message>
        <source>Not in a plane of the study</source>
        <translation>Nicht in einer Ebene der Studie</translation>
    </message>
</context>
<context>
    <name>PatientQuestion</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>date of birth</source>
        <translation>Geburtsdatum</translation>
    </message>
    <message>
        <source>sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Another patient?</source>
        <translation>Anderer Patient?</translation>
    </message>
    <message>
        <source>The second volume is of another patient than the study. What differs: %1.</source>
        <translation>Das zweite Volumen ist von einem anderen Patienten als die Studie. Das weicht ab: %1.</translation>
    </message>
    <message>
        <source>Open it only if you know that both are of one patient, or mean to compare two patients. Pictures of it will say so.</source>
        <translation>Öffnen Sie es nur, wenn sicher ist, dass beide von einem Patienten sind, oder um zwei Patienten zu vergleichen. Bilder davon sagen es.</translation>
    </message>
    <message>
        <source>&amp;Open All the Same</source>
        <translation>&amp;Trotzdem öffnen</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>Axial slices; 3D is not shown</source>
        <translation>Axiale Schichten; 3D wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Coronal slices; 3D is not shown</source>
        <translation>Koronale Schichten; 3D wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Sagittal slices; 3D is not shown</source>
        <translation>Sagittale Schichten; 3D wird nicht gezeigt</translation>
    </message>
</context>
<context>
    <name>PictureTexts</name>
    <message>
        <source>In colours: %1</source>
        <translation>In Farben: %1</translation>
    </message>
    <message>
        <source>Middle of the slab: %1</source>
        <translation>Mitte des Slabs: %1</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>Measurements are of the study alone</source>
        <translation>Messungen gelten nur für die Studie</translation>
    </message>
    <message>
        <source>Segments: middle of the slab</source>
        <translation>Segmente: Mitte des Slabs</translation>
    </message>
    <message>
        <source>No memory for this picture: make the window smaller</source>
        <translation>Kein Speicher für dieses Bild: machen Sie das Fenster kleiner</translation>
    </message>
    <message>
        <source>Segments: fractions of half or more</source>
        <translation>Segmente: Anteile ab der Hälfte</translation>
    </message>
    <message>
        <source>Segments: nearest voxel of another grid</source>
        <translation>Segmente: nächstes Voxel eines anderen Rasters</translation>
    </message>
    <message>
        <source>Low values are white, as in the images</source>
        <translation>Niedrige Werte sind weiß, wie in den Bildern</translation>
    </message>
    <message>
        <source>Low values are white, as is custom for PET</source>
        <translation>Niedrige Werte sind weiß, wie bei PET üblich</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>Interpolated between dashed lines: no image was taken there</source>
        <translation>Zwischen gestrichelten Linien interpoliert: dort wurde kein Bild aufgenommen</translation>
    </message>
    <message>
        <source>Some of these slices are interpolated</source>
        <translation>Einige dieser Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>Some slices of the slab are interpolated</source>
        <translation>Einige Schichten des Slabs sind interpoliert</translation>
    </message>
    <message>
        <source>Interpolated: no image was taken here</source>
        <translation>Interpoliert: hier wurde kein Bild aufgenommen</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>The preset %1 is made for values in %2; those of this volume are %3. What it shows here, and in which colours, means nothing.</source>
        <translation>Die Voreinstellung %1 ist für Werte in %2 gemacht; die dieses Volumens sind %3. Was sie hier zeigt und in welchen Farben, bedeutet nichts.</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>einer anderen Einheit</translation>
    </message>
    <message>
        <source>raw numbers of the scanner</source>
        <translation>rohe Zahlen des Geräts</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>The preset %1 is made for %2; this volume is %3. Its colours may mean something else here.</source>
        <translation>Die Voreinstellung %1 ist für %2 gemacht; dieses Volumen ist %3. Ihre Farben können hier etwas anderes bedeuten.</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>%1 in pixels, 1 to %2</source>
        <translation>%1 in Pixeln, 1 bis %2</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ohne</translation>
    </message>
</context>
<context>
    <name>QuitQuestion</name>
    <message>
        <source>Quit?</source>
        <translation>Beenden?</translation>
    </message>
    <message>
        <source>If you quit now, no file of it is left.</source>
        <translation>Wenn Sie jetzt beenden, bleibt keine Datei davon übrig.</translation>
    </message>
    <message>
        <source>&amp;Finish, Then Quit</source>
        <translation>&amp;Fertigstellen, dann beenden</translation>
    </message>
    <message>
        <source>&amp;Quit Now</source>
        <translation>&amp;Jetzt beenden</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>%1 at centre</source>
        <translation>%1 in der Mitte</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>SecondVolumeTexts</name>
    <message>
        <source>phantom</source>
        <translation>Phantom</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Prior: %1</source>
        <translation>Voraufnahme: %1</translation>
    </message>
    <message>
        <source>Later: %1</source>
        <translation>Später: %1</translation>
    </message>
    <message>
        <source>Second, same day: %1</source>
        <translation>Zweites, gleicher Tag: %1</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Zweites: %1</translation>
    </message>
    <message>
        <source>ANOTHER PATIENT than the study</source>
        <translation>ANDERER PATIENT als die Studie</translation>
    </message>
    <message>
        <source>The images do not tell whether both are of one patient</source>
        <translation>Die Bilder sagen nicht, ob beide von einem Patienten sind</translation>
    </message>
    <message>
        <source>Current: %1</source>
        <translation>Aktuell: %1</translation>
    </message>
    <message>
        <source>Registration is doubtful: nearly as good %1 mm away; check landmarks</source>
        <translation>Registrierung unsicher: %1 mm daneben fast ebenso gut; Landmarken prüfen</translation>
    </message>
    <message>
        <source>Registration is doubtful (%1 mm): check landmarks</source>
        <translation>Registrierung unsicher (%1 mm): Landmarken prüfen</translation>
    </message>
    <message>
        <source>Registered, rigid; searches agree to %1 mm</source>
        <translation>Registriert, starr; Suchläufe stimmen auf %1 mm überein</translation>
    </message>
    <message>
        <source>Not registered: positions cannot be compared</source>
        <translation>Nicht registriert: Orte sind nicht vergleichbar</translation>
    </message>
    <message>
        <source>%1 to %2 %3, %4 % of the highest</source>
        <translation>%1 bis %2 %3, %4 % des höchsten</translation>
    </message>
    <message>
        <source>Same frame, not registered: the patient may have moved</source>
        <translation>Gleiches Koordinatensystem, nicht registriert: evtl. bewegt</translation>
    </message>
</context>
<context>
    <name>SegmentEdits</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Segment in colour</source>
        <translation>Segment farbig</translation>
    </message>
    <message>
        <source>Segments in 3D</source>
        <translation>Segmente in 3D</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
</context>
<context>
    <name>SliceKeys</name>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
</context>
<context>
    <name>SliceMenu</name>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>&amp;Keep This Window…</source>
        <translation>Diese Fensterung &amp;behalten…</translation>
    </message>
    <message>
        <source>Under a name, for all studies with values of this unit</source>
        <translation>Unter einem Namen, für alle Studien mit Werten in dieser Einheit</translation>
    </message>
    <message>
        <source>&amp;Remove a Window</source>
        <translation>Fensterung &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Label…	Enter</source>
        <translation>Be&amp;schriftung…	Eingabe</translation>
    </message>
    <message>
        <source>Words beside this measurement</source>
        <translation>Wörter neben dieser Messung</translation>
    </message>
    <message>
        <source>Keep This Window</source>
        <translation>Diese Fensterung behalten</translation>
    </message>
    <message>
        <source>Name of the window %1</source>
        <translation>Name der Fensterung %1</translation>
    </message>
    <message>
        <source>&amp;Fit the Pane	%1</source>
        <translation>&amp;Ins Bildfeld einpassen	%1</translation>
    </message>
    <message>
        <source>The whole slice is seen, in the middle of the pane</source>
        <translation>Die ganze Schicht ist zu sehen, in der Mitte des Bildfelds</translation>
    </message>
</context>
<context>
    <name>SlicePainting</name>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
</context>
<context>
    <name>SliceTool</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>All panes go to the point that is clicked or dragged to</source>
        <translation>Alle Bildfelder gehen zu dem Punkt, der angeklickt oder auf den gezogen wird</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Drag: wider to the right, brighter up</source>
        <translation>Ziehen: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag: closer up, farther down</source>
        <translation>Ziehen: nach oben näher, nach unten weiter weg</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Drag the picture sideways</source>
        <translation>Das Bild seitwärts ziehen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Measure from point to point, in mm</source>
        <translation>Von Punkt zu Punkt messen, in mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Measure between two legs, in degrees</source>
        <translation>Zwischen zwei Schenkeln messen, in Grad</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Measure area, in mm², and values within it</source>
        <translation>Fläche in mm² und Werte darin messen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Read the value of the voxel that is pointed at, in its unit</source>
        <translation>Den Wert des Voxels unter dem Zeiger ablesen, in seiner Einheit</translation>
    </message>
</context>
<context>
    <name>SliceWindowing</name>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Window of the second volume</source>
        <translation>Fensterung des zweiten Volumens</translation>
    </message>
</context>
<context>
    <name>Slices</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1, oblique</source>
        <translation>%1, schräg</translation>
    </message>
    <message>
        <source>%1 %2 %3 mm</source>
        <translation>%1 %2 %3 mm</translation>
    </message>
    <message>
        <source>%1, slice %2 of %3</source>
        <translation>%1, Schicht %2 von %3</translation>
    </message>
    <message>
        <source>%1, image %2</source>
        <translation>%1, Bild %2</translation>
    </message>
    <message>
        <source>MIP %1 mm</source>
        <translation>MIP %1 mm</translation>
    </message>
    <message>
        <source>MinIP %1 mm</source>
        <translation>MinIP %1 mm</translation>
    </message>
    <message>
        <source>Mean %1 mm</source>
        <translation>Mittelwert %1 mm</translation>
    </message>
    <message>
        <source>Outside, %1</source>
        <translation>Außerhalb, %1</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Füllwert</translation>
    </message>
    <message>
        <source>%1 at (%2, %3, %4), %5</source>
        <translation>%1 bei (%2, %3, %4), %5</translation>
    </message>
    <message>
        <source>%1, not calibrated</source>
        <translation>%1, nicht kalibriert</translation>
    </message>
    <message>
        <source>%1, ends in interpolated slices</source>
        <translation>%1, endet in interpolierten Schichten</translation>
    </message>
    <message>
        <source>%1, %2 % interpolated</source>
        <translation>%1, %2 % interpoliert</translation>
    </message>
    <message>
        <source>%1, interpolated,</source>
        <translation>%1, interpoliert,</translation>
    </message>
</context>
<context>
    <name>Visibility</name>
    <message>
        <source>its values are %1 to %2 %3</source>
        <translation>seine Werte sind %1 bis %2 %3</translation>
    </message>
    <message>
        <source>All of this volume is %1 in the window %2: %3.</source>
        <translation>Dieses Volumen ist in der Fensterung %2 ganz %1: %3.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>schwarz</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>This volume has no values: all of it is padding.</source>
        <translation>Dieses Volumen hat keine Werte: es besteht nur aus Füllwerten.</translation>
    </message>
    <message>
        <source>Nothing of this volume can be seen with the preset %1: %2.</source>
        <translation>Mit der Voreinstellung %1 ist von diesem Volumen nichts zu sehen: %2.</translation>
    </message>
    <message>
        <source> Presets that show something of it: %1.</source>
        <translation> Voreinstellungen, die etwas davon zeigen: %1.</translation>
    </message>
</context>
<context>
    <name>WindowContainer</name>
    <message>
        <source>Sides of the patient at the left, right, top and bottom: %1, %2, %3, %4</source>
        <translation>Seiten des Patienten links, rechts, oben und unten: %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm</source>
        <translation>Links ziehen oder Pfeile gehen um den Patienten herum, das Rad geht näher; Größen sind in mm</translation>
    </message>
    <message>
        <source>The volume in 3D</source>
        <translation>Das Volumen in 3D</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>The file could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space and permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is larger than {} bytes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs {}{}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be written: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system has no random numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder to write into does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create it, or choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands there is no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or choose something smaller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system has no memory or threads left to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system gave an error when the program was to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check disk, connection and permissions, and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program could not {}: a size in it is beyond all bounds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy it again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program could not {}, for a reason that it did not foresee.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it fails again, report it, with the log of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key that makes identifiers unreadable for others could not be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space and permissions of that folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file with the key that makes identifiers unreadable for others cannot be read, or holds none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring it back from a backup, or remove it: then a new one is made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another segmentation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of Macula could not be loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install Macula again, with the packages that it depends on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D picture has values of 16 bits, with an error of at most {:.3g}{}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D picture shows values below {:.4g}{} or above {:.4g}{} as these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image has no usable size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This series is no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images of this series have no usable size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images of this series differ in size or in kind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values of these cannot be what the images say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decoding {} slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to decode the slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compressed image in this file is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The JPEG 2000 image in this file cannot be decoded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel data of this file are damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file ends before its pixel data do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This version cannot decode this image: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the series uncompressed or in JPEG 2000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the file or disc is still there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has changed since the folder was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has no pixel data that fit its header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be told where the images in this file begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to decode a slice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel data of this file cannot be decoded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images of this file have no usable size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the file again from its source, or choose another presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state does not say in which colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state does not say which images it is of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of something that is no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state does not say which series it is of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state does not say where it is looked from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is drawn by a method that Macula does not know.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours of the presentation state are damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state has a table of values (VOI LUT) before its colours, which Macula does not know.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state does not say which values its colours are of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A clip of the presentation state is missing in the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A clip of the presentation state is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is not a DICOM presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no presentation state of one rendered volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for the presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The label of the presentation state is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take 1 to 16 capital letters, digits, blanks and underscores.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The description is too long, or has characters that it may not have.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take at most 64 letters, digits and signs, without a backslash.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view is too large for a presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save it as a view, or remove measurements and large presets from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours of the presentation state are not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another preset, or a window above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera of the presentation state is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip of the presentation state is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The opacities of the presentation state are not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shading of the presentation state is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with a frame of reference, and this volume has none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save it as a view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files of this study do not say which patient and which study it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the presentation state without patient and study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DICOM file could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space and memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path is longer than this system can open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the folder nearer to the root of the disk, or give the folders shorter names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is a folder, and its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is not the directory of a DICOM disc.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dictionary of the DICOM toolkit (dicom.dic) is not there, so that DICOM files cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install DCMTK&apos;s data files again, or set DCMDICTPATH to the path of dicom.dic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading a segmentation of {} frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation ends before its last frame does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation changed while it was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the study again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of the segmentation do not lie on one grid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Putting segments on the voxels of the volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series of the segmentation is no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no segmentation that this version knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of the segmentation are of no kind that this version knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation does not say what its values mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation does not say where all of its frames lie.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation does not say where its frames lie.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation does not say what its frames show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart for a grid of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it with the series it was drawn on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation has more segments than a label map can hold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {} of the segmentation does not lie on the voxels of the series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the segmentation with the series it was drawn on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segmentation has no frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing {} files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images at one position were told apart by the order of their numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study that it belongs to cannot be read any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the study again, or write it without the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DICOM file could not be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A DICOM file could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder to write into cannot be created.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the permissions, or choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing {} slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder to write into is not empty, or cannot be replaced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder that is empty or does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space, memory and permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no MetaImage file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image has several values in each voxel; a volume needs one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values of the image are neither whole numbers of 8 to 64 bits nor floating-point ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values have 8 bytes each, as the size of the file tells, and not 4 as their type says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not give the distance of the voxels: 1 mm was assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values are written as text, which Macula does not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the file with BinaryData = True.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values lie in several files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the volume to one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert it with the program it comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is cut off or damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Get the file again from where it came.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A NIfTI file holds no volume of {} x {} x {} voxels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a .nrrd or .mha file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the path and its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no NIfTI file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image is in colour; a volume needs one value in each voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values of the image have NIfTI&apos;s data type {}; Macula reads whole numbers of 8 to 64 bits and floating-point ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of the NIfTI file is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file gives two positions in the patient that differ by up to {:.1f} mm (sform and qform): the sform was taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the right, to the front and up. Left and right may be exchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file with the values (.img) is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put it beside the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is an ANALYZE file, which does not tell left from right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as NIfTI.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of the image in the patient is not usable: its axes do not span a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no NRRD file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image has several values in each voxel, or an axis of time; a volume needs one value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of the image is not given in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An axis of the image does not lie in space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write one volume to a file of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values are encoded in a way that Macula does not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the file with the encoding raw or gzip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text stands before the values, which Macula does not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole numbers beyond 2^53 were rounded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values were rounded to 24 significant bits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} voxels hold no finite number: they are treated as outside of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The size of a voxel is not calibrated: lengths, areas and volumes are estimates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds {} volumes, one for each point in time; this is number {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image of {} x {} x {} voxels is no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file with a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A volume of {} x {} x {} voxels cannot be shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is cut off: its header tells of {} x {} x {} voxels, and it is too short for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map from stored values to units is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the file again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of the file is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image has two axes; it is no volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image has {} axes; Macula reads volumes with three.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values lie in another folder or in several files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the volume to one file, or put the file with the values beside the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file with the values is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ending of the name is that of no volume file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volumes are not written to files with the ending {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file could not be put in place: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough free space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file needs {} MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it did not become whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something unforeseen happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mask does not fit the pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give one number for each pixel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of pixels in a degree is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give 1 to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such fovea in a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a picture of 0.1 to 170 degrees, a gaze inside it, and a field above 0 and at most 180 degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give one number for each pixel of the pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a number for each pixel of the mask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures of {} x {} pixels are too small for MS-SSIM.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare pictures of at least {} pixels on each side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture file is damaged or incomplete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export or download it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space and permissions of the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture file does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture file could not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no Radiance HDR, OpenEXR or PNG picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a file of one of these formats; renaming does not convert it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or use a smaller picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a picture of another format.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no flat picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a picture with one layer of pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is too large: {} by {} pixels, {} channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale it to at most {} pixels on each side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture has too many pixels and channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale it down, or leave channels out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare two pictures of one size, made for display.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures of {} x {} and {} x {} cannot be compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare two pictures of one size, both in colour or both grey.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of the series can be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another preset or clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview around the sharp centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sharp centre traced {:.1f} s ago with {} samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>estimated from the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values on cut faces only coarsely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the preview is not sharp enough after {} steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview fades out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preview where it is less noisy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/{} of the pixels each way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than the full resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>denoised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} samples left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to write the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished">Wird geöffnet</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only what is path-traced has a peripheral model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the look cinematic or clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to be seen that a model could learn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics device has no memory for a model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or show less of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model could not be made on this graphics device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try another device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics device stopped responding and was started again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture of this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw it again; if that does not help, open another device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This was opened without a model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it with one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Training</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no model of what is shown yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Train it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No folder was given to keep models in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has learnt nothing yet that could be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored model was not replaced: it has learnt more than this one, or could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Train this one for longer, or check free space and permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model could not be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check free space and permissions of the folder that was given for models.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A handle of the graphics device that is lent is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give VkInstance, VkPhysicalDevice, VkDevice, and a VkQueue of it with compute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The queue that is lent can be locked, or unlocked, but not both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give both functions, or neither.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s name says no format.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name says no format that splats alone are written in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has learnt nothing yet that training could go on with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the picture converges, or save it as .ply, .spz or .glb.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation type="unfinished">Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>What goes on learning needs linear colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save it as .ply, .spz or .glb, or without colours as displayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped before the first step; nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The saved training has no views to learn from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Train anew, with --views above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The saved training has all of its {} steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --iterations for as many more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The saved training does not say what its pictures show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is of another program, or of an older one: train anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The saved training is of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored sessions were not changed, because Macula found a mistake of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stored model is damaged, and is not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`macula sessions verify` says what else is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How this study was left was not found in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is kept: open the study again to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More was measured on this study than is shown here: another window has it open, or had.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it is kept; open the study again to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name has letters that cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name has letters that cannot be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type it anew, without pasting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use at most {} letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a preset of that name already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are too many presets of your own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete some first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera cannot be kept: a part of it would be lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the curve alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A built-in preset cannot be renamed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An export cannot lie inside of the stored sessions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a place elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are the stored sessions themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder that macula sessions export wrote.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} left, because models of theirs are open. Close other windows of Macula and purge once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of damaged files may hold parts of what was deleted; --damaged-too deletes them as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. {}, among them {} and {}, were rescued; the damaged file is kept in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored sessions were brought to the format of this version; older ones cannot read them now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other users of this computer may be able to read stored sessions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. It was set aside, and what could be read of it was rescued.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`macula sessions verify` says what is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} studies begin with {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give more digits: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is stored yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check --folder if you expected studies here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study is named by the first {} or more of its digits, 0 to 9 and a to f.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stored study begins with {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The segments of the view are not here; all of the volume is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view has a second volume in the picture; give it by --second to draw both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--second does nothing in this look: it is of all but projections.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a folder of DICOM files can have segmentations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave --segments out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing until the noise is gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of the model&apos;s splats hold what is no number or no rotation, or are so large that they would fill every picture: left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model holds no splats: the pictures are empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This model is one of Macula&apos;s and has a low-pass of its own: --low-pass does nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a folder of that name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be written there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is one of those that are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another name: what is read is never replaced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file belongs to the folder that is read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file exists already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --overwrite to replace it, or choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two outputs have the same name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give each a name of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diameter of the lens is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give 0 to {:g} mm; 0 is none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance of what is sharp is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a number above 0, up to {:g} mm, or auto.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The depth of the fog is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give {:g} to {:g} mm, or 0 for none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle of the picture shows nothing that a lens could be focused on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the camera, or give the distance in mm of what is to be sharp: --focus-mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera stands in what the middle of the picture shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture must be a .png or .exr file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give -o a name with one of these endings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The small picture was not drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures of presets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every voxel of the series is padding: there is nothing to draw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder is not empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another one, or empty it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} does nothing in this look: it is of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} does nothing, as the preset has no curves for steep matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} does nothing, as the preset has no surface: --surface gives it one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--focus-mm does nothing without --lens-mm: all is sharp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This look is never denoised: --denoise does nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--background does nothing in an EXR, which has coverage instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--keep-unfinished does nothing without --error: nothing is written when stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of light has no cube, scale and letters over it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture cannot have that size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take 1 to {} pixels for each side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sequence cannot have that many pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take 1 to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way of the camera has no view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder holds pictures of another sequence.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an empty folder, or make a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} was opened without what Macula needs of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it with VK_KHR_push_descriptor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} cannot be used: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update its driver, or choose another device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no graphics device &quot;{}&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one by its number or a part of its name: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics device that was lent is not one of its VkInstance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the VkInstance and the VkPhysicalDevice that the device was made of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset asks for a graphics device that is not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the headset&apos;s software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program that lends a graphics device gave none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a device, a queue of it, and what it was made of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The queue that was lent is of a family that cannot compute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a queue with compute, and the number of its family.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} does not offer {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update its driver, or choose another device with MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This program has as many files open as it may, so what is shared cannot be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close what is not needed, or let the program open more files (ulimit -n).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file descriptor of what is shared is not open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give one that vkGetMemoryFdKHR or vkGetSemaphoreFdKHR made, and close it afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no Vulkan driver on this computer, so nothing can be rendered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install the driver of the graphics card, or, to render on the CPU, the Debian/Ubuntu package mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Vulkan validation layer was asked for, but is not installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install it (Debian/Ubuntu: sudo apt install vulkan-validationlayers), or unset MACULA_VALIDATION.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Vulkan driver of this computer does not offer {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the graphics driver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics device stopped responding {} times within a minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device: `macula devices` lists them, --device or MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} does not fit on the device {}: it needs {}, and the device allows {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a smaller series, or choose a device with more memory by MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image is of another graphics card, or another driver, than {}, which draws.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask macula_device_identify which card draws, and make the image on that one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} was opened without what images are shared by.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it with VK_KHR_external_memory_fd; where it does not offer that, have pictures in memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} cannot open a shared image like this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share one of VK_FORMAT_R8G8B8A8_UNORM with optimal tiling, and for fewer uses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} shares an image only with memory of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allocate it with VkMemoryDedicatedAllocateInfo, and say so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image needs {} bytes at a multiple of {}, and has {} at {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory is said to be the shared image&apos;s alone, which needs {} bytes and not {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image needs memory of its own, and is said to have none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image cannot lie in memory of type {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::memoryTypeIndex of the memory that is shared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} has no {} of memory that could be shared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was shared is no memory of this graphics card, or smaller than it is said to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetMemoryFdKHR with VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, and the size of the allocation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} cannot share semaphores with another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} was opened without what semaphores are shared by.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was shared as a semaphore is none of this graphics card.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetSemaphoreFdKHR with VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An image of {} x {} pixels cannot be shared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give one of 1 to {} pixels a side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixels of the shared image are of a kind that Macula does not write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share one of VK_FORMAT_R8G8B8A8_UNORM or VK_FORMAT_R8G8B8A8_SRGB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tiling of the shared image is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share one of VK_IMAGE_TILING_OPTIMAL or VK_IMAGE_TILING_LINEAR.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image was not made for being written to, or for more than is known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it with VK_IMAGE_USAGE_TRANSFER_DST_BIT, and no more than transfers, sampling, storage, and attachments of colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image was made with flags that Macula does not know.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use no more than those for a mutable format, extended usage and aliases.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared image cannot be left in the layout that was asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask for VK_IMAGE_LAYOUT_GENERAL, or for a layout of something that the image was made for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No memory was shared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetMemoryFdKHR, above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared memory of {} bytes has no room for an image of {} x {} pixels at byte {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::allocationSize, and the offset that the image was bound at.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dedicated allocation has its image at the beginning, and this one has not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the offset 0, or share memory that is not dedicated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shared memory is of a type that does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::memoryTypeIndex.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was not said which graphics card the shared memory is of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give deviceUUID and driverUUID of VkPhysicalDeviceIDProperties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was shared as {} is a file, a pipe, a socket or a folder, and no {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a file descriptor of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A shader cannot be used: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build Macula again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device {} cannot draw in this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the device that drives the display by MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not {}: the computer&apos;s memory is full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or open a smaller series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not {}: the graphics memory is full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs that draw in 3D, open a smaller series, or choose another device with MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not {}: the graphics device stopped responding and was reset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again. If this comes back, update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not {}: the window system took the window away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the window again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Could not {}: the graphics driver reports {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light is learnt from what an eye sees, not from parallel rays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a camera that is not parallel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The training was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a preset that shows something of the series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The state of the peripheral model is damaged: its parts do not belong together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load it again, or have it learnt anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for pictures cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the path and the permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lighting views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Splats learn from what an eye sees, not from parallel rays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples of what is compared with cannot be halved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give an even number of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing what is compared with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This device runs too few threads together to train models.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another device: `macula devices` lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of {} x {} pixels cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a size from 1 to {} on each side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera&apos;s near plane is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a distance from 0.001 to 1000000 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera&apos;s orientation is not a rotation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give three perpendicular unit axes that are not mirrored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera&apos;s position is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a position within 1000 km of the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera&apos;s focal length is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose 0.01 to 100000000 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera&apos;s principal point is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a point within 1000000 pixels of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way in which splats blend is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a low-pass of 0.01 to 100 square pixels, the least of it no more, a most opaque splat of 0.01 to 0.9999, a faintest of 1e-9 to 0.009, a fringe of 1.1 to 1000000, and a least transmittance of 0 to 0.1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of {} x {} pixels is too large for this device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one of at most {:.1f} million pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The splats of this model are too large and too many for this device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a smaller picture, or a model of fewer splats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no memory for the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is damaged or cut off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy it again, or train it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is a .macula file of version {}; this Macula reads version {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no memory to pack or unpack the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is too large for a glTF file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as .ply instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model holds no splats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Train it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the model again from where it came.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file is damaged or cut off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file is not of version 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it as binary glTF 2.0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file holds far more than a model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the model alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file holds no Gaussians.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one with the extension KHR_gaussian_splatting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Gaussians of the glTF file are of another kind than ellipses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file has colours in linear light of a display, which cannot be drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it with colours in sRGB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Gaussians of the glTF file are packed in a way that is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it without compression, or as PLY or SPZ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Gaussians are not in the glTF file itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it as one binary file (.glb), without compression.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The glTF file lacks the attribute {} of some Gaussians.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is larger than any {} model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is a folder, not a model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a model of Gaussians, or convert it to PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the file one of these extensions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export or train it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is one of Macula&apos;s, but what it says about its {} is not understood.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is damaged or of a later version: export it again, or use a newer Macula.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low-pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the file says about the settings of its training is not understood.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is damaged or of another version: go on with the Macula it was begun with, or train anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file is cut off or damaged at splat {} of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file is cut off: its header counts {} {}, for which it is too small.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file is cut off or damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model does not fit into memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or export a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file holds no points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a model of Gaussians.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of the PLY file {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is longer than that of any model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names a version that is not 1.0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names an unknown format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counts fewer elements than none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not say how many elements there are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a list whose length is no whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names an unknown type of number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a property without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a line that is none of a PLY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not name a format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file holds a model in the packed form of SuperSplat, which is not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it there as a PLY that is not compressed, or as SPZ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file has a list in the place of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file has {} twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file is no model of Gaussians: it lacks {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a model as 3D Gaussian splatting writes it, not a mesh or a point cloud.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PLY file has {} coefficients of colour f_rest; 0, 9, 24 or 45 without a gap are understood.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it with spherical harmonics of degree 3 or less.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file is cut off or damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model reaches farther than an SPZ file can say: 8 km from its origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the splats that are so far away, or write a PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is gzip, but no SPZ model is in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file has version {}; 1 to {} are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert it to version 4, or to PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file has spherical harmonics of degree {}; 0 to {} are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export it with a lower degree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file counts {} splats; no more than {} are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert it to PLY, of which there is no such limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file counts {} splats, for which it is too small.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has {} splats; an SPZ file holds at most {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s splats are so much alike that its SPZ file could not be told from a false one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is larger than any SPZ model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The SPZ file names axes (number {}) that this version does not know.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert it to one with the axes of the format (right, up, back), or to PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no training that could go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a .macula file, or train anew: PLY and SPZ hold only the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model has spherical harmonics of degree {}; 0 to {} are supported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is damaged: it does not have the same number of entries for all properties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load or train it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model&apos;s place in the patient is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of the {} splats of the model hold values that are not numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings of the training make no sense.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position rates and decays must be above 0, other rates not below 0, both betas from 0 to below 1, and epsilon from 1e-30 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The state of the training does not fit the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was saved for another model, or is damaged: train anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture to learn from is empty or not of its view&apos;s size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures are halved 0 to 15 times, the weight of D-SSIM and the shares of splats are 0 to 1, the exposure and the steps between density control above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models of this degree of colour can be shown, but not trained.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduce the model to degree 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture to learn from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add views first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The training was begun by version {} of the trainer, and would go on otherwise with version {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the Macula it was begun with, or train anew; its model can still be drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The state of the training is damaged: its parts do not belong together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load it again, or train anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to trace yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation type="unfinished">Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A volume of more than 2147 million voxels cannot be masked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it without a mask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A volume of {} million voxels is more than can be traced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a smaller series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another environment, or a built-in light rig.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projections show all of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another look.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search for points on the surface was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This look traces no paths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the cinematic look.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a number from 0 to {} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a number above 0, up to {} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A parallel view has no fovea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace all of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The foveation is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a gaze inside the picture, a field above 0 and below 170 degrees, and 1 to 16 times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This number of points on the surface makes no sense.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no second volume with a preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a second volume, and choose a preset for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the second volume lies is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register the two volumes again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coloured segments are not of this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the segmentation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A coloured segment has no colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour of a segment is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give red, green, blue and opacity from 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip is not usable: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset has no range of values that could be fitted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use it without fitting, or give it an effectiveRange.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a built-in opacity table, or a 16-bit CLUT, and save the preset again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The filters of the preset are not applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point of {} has no usable {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it a number from {:g} to {:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} of the transfer function has {} points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it 1 to {} points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The version of the MITK transfer function is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only version 1 can be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacities or colours outside 0 to 1 were clamped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour map has no opacities; a ramp from 0 at its first to 1 at its last colour was taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the first volume property, and its first component, are used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the table beside the preset as NAME.plist, or save a 16-bit CLUT with the preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a JSON preset, a .vp or presets.xml of 3D Slicer, a ParaView or VolView JSON, an XML of MITK, or a plist of Horos.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds {} presets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds a number that cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a key without a value, or a value without a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The property list is in its binary form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert it on a Mac: plutil -convert xml1 FILE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no property list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A .vp file of 3D Slicer has {} lines; this has {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {} is not as expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} of the preset {} is no number from 0 to {:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct it, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use 0 for nearest or 1 for linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds too many presets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split it into files of at most {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no volume property of 3D Slicer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a presets.xml, or an MRML scene with volume rendering.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {} of the preset {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the preset again in the program that it comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registration was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link the volumes by hand, or choose another series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registering the second volume</source>
        <translation type="unfinished">Das zweite Volumen wird registriert</translation>
    </message>
    <message>
        <source>There is not enough memory to register the volumes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or link the volumes by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera {} of the path is none: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This model was made elsewhere and does not say where the patient&apos;s left or front is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --camera or --cameras, or none of these to look along its own +z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no list of cameras.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --cameras the cameras.json that was written beside the model; --camera takes one of Macula&apos;s own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds a list, not one camera of Macula&apos;s own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it as --cameras.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no cameras.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is the cameras.json of this model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture holds display colours, not light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a Radiance HDR or OpenEXR picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is {} by {} pixels, not twice as wide as high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give an equirectangular panorama.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture holds {} values that are not finite and {} negative ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repair it, or give another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no such lights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture is no rig of lights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose lights by name, or those of a JSON file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These lights hang on the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A peripheral model holds light that stays where it is: choose lights of the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The size of the picture is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --size as WIDTHxHEIGHT in pixels, each from 1 to {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --window as CENTRE,WIDTH in units of the series, the width above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The background is not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --background as R,G,B, each from 0 to 1: 1,1,1 is white.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That part of the clip is not there any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take hold of another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This clip cannot be kept with the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the clips, and cut again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hiding voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hiding voxels was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to hide parts of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or hide less. The picture and what is chosen stay as before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The place of the clip is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it in mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of the volume would be left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another place, or begin without a clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A clip with a box of another kind has six planes and no more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another face first, or begin without a clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is left to remove on the {} side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the cross-hair into what is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slab has no thickness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it in mm, more than 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slab would be outside of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the cross-hair into the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corner would be outside of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ball of that size is not possible here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a radius from {:.4g} to {:.4g} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ball would be outside of the volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no clip to turn inside out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a clip, or cut something off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a clip of one part can be turned inside out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This one has {}; begin without a clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The depth of the cut is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip leaves nothing of this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again without a clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw around what is to be removed, in one go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting with the scissors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cut was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the outline around less, or keep the inside with Shift.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to cut this volume with the scissors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or clip with a box, planes or a ball.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hues kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What may be a table is shown, as Macula cannot tell it from the patient for sure; --remove-table leaves it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--keep-table shows what was left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view keeps or hides segments; here they change nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view has segments in colour; here they have none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view has a second volume in the picture; here it is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The background is no colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give black, white, grey, or red, green and blue as #rrggbb: #202830 is a dark blue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another one of the rig.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without any light the picture would be black.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave a light, or a sky that is not black.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rig has no room for one more light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with identifiers and a frame of reference, and this series has none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture yet to make a presentation state of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the study is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of other images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the series of these images, or choose another presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No DICOM study is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the series of the presentation state first.</source>
        <translation type="unfinished">Öffnen Sie zuerst die Serie des Presentation State.</translation>
    </message>
    <message>
        <source>What a newer Macula has written cannot be read; the picture is as others show it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of another series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open that series, or choose another presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, such as another phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the volume of these images, or another presentation state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, too, or of a part of these alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state is of the values of the images, and this PET is shown in SUV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a preset or a window in SUV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What lies before or behind the depth of its view is shown, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second volume: Same frame of reference, not registered: the patient may have moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second volume was registered, to {:.1f} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of the second volume lies in the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another series by --second-series, or register both by --registration search.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view was saved with another second volume: its place and look are not those of this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second volume is of another patient than the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a series of the same patient by --second and --second-series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not tell whether both volumes are of one patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second volume is the study itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another series by --second-series, of those that macula info lists, or another file by --second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no second volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give its folder or file by --second, or leave out what else is said of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gradient opacity of the second volume&apos;s preset is not drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second volume&apos;s preset is drawn without its curves of steep matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hiding segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hiding segments was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to hide segments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or hide fewer. The picture and what is chosen stay as before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than 255 segments of different colours cannot be shown in 3D.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour fewer of them, or give some the same colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colouring segments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colouring segments was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to colour segments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or colour fewer. The picture and what is chosen stay as before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That does not say what to do with which segment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write keep:LABEL, hide:LABEL or colour:LABEL; macula info lists the labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No segmentation of this volume has a segment of that label.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>macula info lists the labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A segmentation of the view is not in the folder, and nothing of it is kept, hidden or coloured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No voxel of these segments lies in the volume; all of it is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements are written to a .csv or .json file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a name with one of these endings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A window is kept under a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type one, such as Kidney.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are {} windows of your own already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>namedClips: expected another thing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A list of at most {} clips.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view was saved of another series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open that series, or choose another view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view was saved when the images lay in other places, or of another volume of the series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it anew; or choose the volume that it is of. Without &quot;grid&quot; in the file it is taken as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values were not counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient could not be told from the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, or show the volume with the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telling the patient from the table was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telling the patient from the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show these images with the table, or cut it away with a clip plane or box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to tell the patient from the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copy of stored sessions was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copying stored models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing stored models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking the database</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking stored models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the folder or a file in it is read-only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the disk is full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the drive cannot lock files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored sessions are in use by another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of stored sessions is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored sessions were written by a newer version of Macula.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for sessions holds files of another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk reported an error while sessions were read or stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to read or store sessions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stored model is damaged; it was set aside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model is larger than all that may be stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored model is no longer there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stored setting is damaged; it was set aside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is to be stored is no valid setting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder holds no exported sessions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data are deleted, but traces may remain in a file that another program is reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series has {} segmentations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one of them with --volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no segmentation {}; the series has {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another with --volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are tilted against their axis, and the file says so; some programs do not understand that, and show the patient askew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of the series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder with a CT or MR series of several parallel slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check its Series Instance UID or number, or choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is not a DICOM image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another series; macula info lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See macula info for the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder; macula info tells more about this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several patients have a series of this UID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose by the number in front of it in macula info.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such series in the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See macula info for the list; --series takes the number in front (3, or 3.2 for its second stack), or the series UID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is one volume; there is nothing to choose from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave --series and --volume out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The phantom has no series to choose from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave --series out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No folder was given: this is the built-in phantom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A series was asked for of what is no folder of DICOM images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask for none, or give a folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This folder is of {}, and nothing says which is meant: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask who knows the patient, and open one of the series by its Series Instance UID or by that number (series_uid).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {} segmentations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading segmentations was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was drawn on other voxels than those of this volume; the nearest voxel is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has fractions; what is half or more is shown as the segment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of its voxels lie outside of this volume, and are not counted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No voxel of it lies in this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for the headset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This build of Macula knows no headsets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build it with the package libopenxr-dev installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no folder for what the session keeps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say --sessions FOLDER, or set TMPDIR.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no display to open a window on, or it does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set DISPLAY or WAYLAND_DISPLAY, or use `macula render`, which needs none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for these pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a smaller size, or close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder, and check free space and permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file may be damaged; choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for both pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation type="unfinished">Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>There is nothing to be seen yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to read the presets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to measure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of settings is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The usual settings are taken; what you set next is saved, and the damaged file is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings could not be saved: their folder cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to keep windows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to count the values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other programs, and open the study again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This kind of display cannot show Vulkan pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use an X11 or a Wayland display, or `macula render`.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window cannot show Vulkan pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install a Vulkan driver for this display.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation type="unfinished">Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the study that the view is of first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for pictures is not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for pictures is full of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty it, or choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset does not say where the eyes are, or what they see.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the headset on, and restart its software if that does not help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset asks for a picture of 170 degrees or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the software of the headset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The software of the headset does not answer as OpenXR 1.0 demands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update or reinstall it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The OpenXR loader is not installed, so no headset can be found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install it (Debian/Ubuntu: sudo apt install libopenxr-loader1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a headset only path-traced pictures can be shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the cinematic or the clear look.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These lights hang on the camera, and in a headset there are two eyes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose lights that stay in place; macula presets lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of this study can be seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another preset, or another clip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The OpenXR runtime that XR_RUNTIME_JSON names cannot be loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct or unset XR_RUNTIME_JSON.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The software of the headset cannot show pictures made with Vulkan (XR_KHR_vulkan_enable2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update it, or use another OpenXR runtime.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset does not say how large its pictures are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the software of the headset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset needs another version of Vulkan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset has ended the session: it was unplugged or fell asleep.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wake it up or plug it in, and begin again; nothing that was chosen is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The software of the headset has stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start it again, and begin again; nothing that was chosen is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No software of a headset (OpenXR runtime) answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start SteamVR, Monado or what came with the headset, and make it the active OpenXR runtime.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No headset is connected, or it is switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect the headset, switch it on, and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The OpenXR runtime knows no headsets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the runtime of the headset the active one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The headset could not {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the whole series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at these images by themselves, or copy the series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the series again, or choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file of this series can be read; it has {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file cannot be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file is listed in the folder, and its content is not on this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect the drive, or make the files available offline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The medium gave an error where something was to be read from it: it is damaged, dirty or failing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean the disc, or check drive and cable, and copy the medium again; else ask for another copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A path is longer than this system can open; what lies there is missing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A DICOM file is damaged and cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A DICOM file ends before its pixel data do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A DICOM image has no pixel data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A DICOM image does not say in a number how many frames it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that the files of this series should have, and that are not there: {missing} of {total}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that hold more than the number of frames they give (NumberOfFrames): {files}. What is beyond is not shown: pixels or descriptions of {frames} frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices may be missing here; copy the series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes follow the pixel data in some files and are no part of the images, which are whole: up to {bytes}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images in which attributes stand twice, with different values: {count} of {total} ({attributes}). Of each the first value is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare values and sizes with those that another program shows; have the images set right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of this series that do not say what kind of object they are: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the series is what it seems to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that do not say by what kind of device they were taken (Modality): {count} of {total}; they were taken for {modality}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders that could not be read: {count}. Images in them are missing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the permissions of the folders, or copy the study again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links that lead out of the chosen folder, and were not followed: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder they lead to, if it is wanted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Archives ({kinds}) in the folder, which were not opened: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unpack those that hold images of this study, and open the folder again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) lists and that are not there: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the medium again; images may be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images say that their study has {total} objects (NumberOfStudyRelatedInstances); {count} of it are here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the study again from its source if all of it should be here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) names outside the chosen folder, and that were not read: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take care where this medium comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that are copies of others of this series, and were left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that have the identifier of another of this series, in a file that differs: {count}. Of each the first file is used; the others are in a stack of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare them before relying on this series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of this series that cannot be read, and were left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text of this series does not fit the character set it declares; names may be shown wrongly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files of this series name different patients or studies, and were split into {count} series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check name, ID, birth date and sex of the patient in every part; slices of this patient may lie in another part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images differ in {attributes}, and were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images have different sizes, and were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some images are in colour and others are not; they were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images lie in different orientations, and were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not share one coordinate system, or some have no position; they were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images have different pixel spacings, and were separated into {count} stacks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose values are in another unit than those of the others, and that are a stack of their own: {count} ({unit}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at both; values of one cannot be compared with those of the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every position was imaged {count} times; each is a volume of its own, told apart by {attribute}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every position was imaged {count} times, and only the order of the image numbers tells them apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the volumes of this series are what they seem to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose {attribute} does not say to which phase they belong, and whose number was asked instead: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare these slices with those beside them before relying on them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images of which nothing says for sure to which acquisition or phase they belong: {numbers}. They are in a stack of their own, and the others lack them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at these images by themselves; part of the scan may have been repeated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phases that have fewer images than the others: {count} of {total}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that lie at the same position as another: {count} of {total}. Nothing in them says which belong together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which images make a volume? Choose another series, or separate the files of this one by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions that were imaged more than once: {count}. Of each, the image with the lowest number is in the volume, and the others are in a stack of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the repeated images before relying on these slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of those that make up one image that are not here: {missing} of {total}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices that seem to be missing beyond the end towards the {side}: {count}; {evidence}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; what lies beyond this end is not shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images of this series that seem to be missing: {count}; {evidence}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; the slices may end too early.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{other} of this study reaches {mm:.0f} mm farther towards the {side} than these slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If both should cover the same, images are missing here: compare with the source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series {number} of this study continues this stack, with the same slice distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at both; together they cover more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a localizer: an overview image, not a slice of a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a series of slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image numbers run {count} times along the patient, and nothing else tells these sets of slices apart; each is a stack of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at all of them; they may be several acquisitions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are {count} even sets, the first two shifted by {offsetMm:.3f} mm against each other, and nothing else tells them apart; each is a stack of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{attribute} changes along the slices, first at slice {slice}; values may step there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not take a step there for a finding.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices {slices} were acquired {minutes:.1f} min before or after those beside them: the patient may have moved, and contrast medium spread.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every other slice differs from those beside it in the same way: two acquisitions may be mixed in this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the original images, slice by slice, before relying on this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images lie in {count} blocks, up to {gapMm:.0f} mm apart; each is a stack of its own, so what is shown is one of {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the other blocks too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every image names a coordinate system (FrameOfReferenceUID) of its own, and together they make an even stack; it was taken for granted that they share one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the slices fit each other. The series is not shown together with others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that name no coordinate system (FrameOfReferenceUID): {count} of {total}. They continue the stack of the others, and it was taken for granted that they share theirs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames belong to {count} stacks (StackID), which make one even volume together and are shown as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that share one identifier (SOPInstanceUID) and lie at different positions: {count}. All are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other programs may show only one of them; have the identifiers set right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that repeat another at the same position, pixel by pixel, and were left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is lost; the series was probably sent twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} images have a {level} identifier each and would make one even stack together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are they one series? Then open the folder with --join.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} images with a {level} identifier each were joined to this series because that was asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that all of them are of one patient and one examination.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is only one slice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a series with more slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not say where they lie in the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say where they lie in the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how they are oriented in the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how large a pixel is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not say how large a pixel is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images say where they lie in a frame of the transducer, and not in the patient: letters of sides, and left and right, are not those of the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not tell sides from this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the first frame says where it lies; it was taken for granted that the others follow it along the slice normal, at the distance that the file gives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If they run the other way, the volume is mirrored: compare with a marker of the side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{attribute} is not written as numbers with backslashes between them, and can be read in no way, or in several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Have it set right, or export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose position, orientation or pixel spacing has other signs between its numbers, or in them, than it should: {count} of {total}. It was read in the only way that there is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure a known length before relying on sizes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The size of a pixel is not calibrated; it was taken from {source}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not measure lengths in these images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The orientation or pixel spacing of a slice is not a valid one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The letters of the sides (PatientOrientation) say the opposite of the orientation in space (ImageOrientationPatient), which is used, in {count} of {total} images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right, or front and back, may be exchanged: compare with the original images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The row and column directions are {error:.4f} off perpendicular unit vectors, and were set right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are turned against each other by up to {degrees:.3f} degrees; they are drawn with the mean orientation, and a voxel is up to {errorMm:.3f} mm away from where it is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow for this error when measuring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices that are missing: {missing} of {total}, which are {spacingMm:.3f} mm apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices of the volume that are interpolated, because no image was there: {count} ({slices}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not read anything into interpolated slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are unevenly spaced, {leastMm:.3f} to {mostMm:.3f} mm apart; they were resampled to an even {spacingMm:.3f} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the original images before measuring across slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are too unevenly spaced for a volume, {leastMm:.3f} to {mostMm:.3f} mm apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose position is missing or cannot be right, and that were left out of the volume: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are not quite evenly spaced: a slice is up to {errorMm:.3f} mm away from where it is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow for this error when measuring across slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images are not parallel to each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not make a volume: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are stacked at an angle of {degrees:.1f} degrees (tilted gantry), and are drawn so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are {thicknessMm:.2f} mm thick and {spacingMm:.2f} mm apart: {percent:.0f} % of what is between the first and the last was never imaged, and is interpolated here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not read anything into what lies between the slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no image, and is not shown by itself: {kind}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images of this kind ({kind}) are no slices of a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images are in colour; a volume needs one value per voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not say in a usable way which bits of a pixel hold its value: neither whole numbers in 1, 8, 16 or 32 bits nor floating point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This version cannot decode the images: {syntax}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose pixels this version cannot decode, and that were left out of the volume: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images say that their pixels are encoded as {said}, and they are as {found}, which they were read as.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Have the images exported again; other programs may not read them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images do not say how a value is shown; greater ones were taken as brighter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each image is a mosaic of many slices (Siemens), which this version does not unpack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the series again as one image for each slice, or convert it with dcm2niix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These values are a dose distribution (unit: {unit}), and no anatomy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To see anatomy, choose the images that the treatment was planned on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values come from a lookup table in the images, which was applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lookup table that makes values of the pixels is not a usable one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rescale slope or intercept of an image is not a usable number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that do not say how stored numbers become values: {count} of {total}. A missing rescale slope was taken as 1, a missing intercept as 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not rely on the values; presets made for Hounsfield units may not fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These CT images do not say that their values are Hounsfield units ({reason}); they are taken as plain numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets for Hounsfield units do not fit, and the table cannot be removed. Use the original images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is missing or cannot be right, and that were left out of the volume: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is another than that of all others; it was applied as it is: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours; if they are brighter or darker, copy the series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each image has its own rescale factors; they are applied image by image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places where the values jump because the rescale slope or intercept changes and the stored numbers do not: {count}, first at slice {slice}, by {step:.4g}. The values on one side are wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not rely on values of this volume; export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose pixels {fault}, and that were left out of the volume: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose pixels {fault}: {count} of {total}. They are shown as the images say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not rely on the values; export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that differ from both of their neighbours far more than these from each other; they are shown as they are: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours, and copy the series again from its source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values are the real world values that the images define, in {unit}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standardised uptake values cannot be worked out: {missing} is missing or not usable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images whose values need more bits than they say, and that were left out of the volume: {numbers}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images with bits outside of those that they say hold the values: {count} of {total}. These bits were dropped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the values with those that another program shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images that say that their values lie higher in a pixel (HighBit) than the bits in use: {count} of {total}. They were read from the lowest bit on; as the images say, values would be a fraction of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels that are no finite number: {count}. They are treated as outside of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not read anything into the places where they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images were compressed with loss; fine detail may be missing or false.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the original images for diagnosis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images have lookup tables that say how they are shown (VOI LUT); these are not used, only windows are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images are meant to be shown with low values bright (MONOCHROME1); values are as stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display window of these images is not usable, and was ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} voxels belong to several segments; of each only the last is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the segments one by one in the program that made them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} voxels of the segmentation lie outside of the volume, and are not shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that no slices of the series are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segment {number} has the number of the background (Pixel Padding Value): nothing of it is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at it in the program that made it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segment 0 has the number {number} in the label map, in which 0 is none of the segments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presentation states: {count}; they are no images, and say how a series is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open one of them in the list of studies; macula render draws those of 3D views.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state has {what}, which cannot be shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with what the program shows that made it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The presentation state has {what}; {how}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed this presentation state of Macula; it is shown as its standard attributes say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table is left out, and whatever else lies apart from the patient: {partsText}, {volumeText} (confidence {confidence}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the table again to see everything that was scanned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No table was found. What lies apart from the patient is left out: {partsText}, {volumeText} (confidence {confidence}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing lies apart from the patient; nothing is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient lies against the table in {slices} of {total} slices of the search grid; the surface between them is an estimate there, to about 3 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not judge the skin of the side that the patient lies on; show the table again for that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not clear what is patient and what is table; nothing is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the table away with a clip plane or box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No patient was found in these images; nothing is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed radiography image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital X-ray image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital X-ray image, unprocessed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mammography image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mammography image, unprocessed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intra-oral X-ray image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray angiographic image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enhanced X-ray angiographic image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray radiofluoroscopic image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enhanced X-ray radiofluoroscopic image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible light image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ultrasound clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ultrasound image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key object selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Structured report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presentation state of slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presentation state of a 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation type="unfinished">Presentation State</translation>
    </message>
    <message>
        <source>Waveform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spatial registration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spatial fiducials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deformable spatial registration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface segmentation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tractography</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label map segmentation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real world value mapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MR spectroscopy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CDA document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiotherapy structure set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiotherapy plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiotherapy object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left drag, arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walk around the patient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag, Shift + arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel, right drag, Ctrl + left drag, + and -</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closer, farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + left drag, Ctrl + Left and Right, [ and ]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the picture: clockwise to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly in: the camera and what it turns around go forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right drag in maximum, minimum, average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + right drag, or drag with T held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transfer function: shift to the right, widen upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click in 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn around what is there, and show it on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window of the series again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from anterior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from posterior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from superior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from inferior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit what is visible</source>
        <translation type="unfinished">Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Parallel rays, or seen by an eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient, study and series over the picture, in title and lists, or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cube and scale, or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on a side of the cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from there, as near as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+1 to Ctrl+6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic, clear, ray cast, maximum, minimum, average</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shade the ray cast, or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the table of a CT, or show it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No clip</source>
        <translation type="unfinished">Kein Beschnitt</translation>
    </message>
    <message>
        <source>Handles of the clip in all pictures, or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + wheel in 3D with handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut across the line of sight: deeper, less deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a handle, Shift + wheel in 3D with the panel of lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a light shines from, how strong it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scissors: draw around what is to go in 3D; with Shift, what stays; or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a folder or a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an image or a volume file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a prior or another volume beside the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second volume in the place of the study, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the view: all that was chosen, and the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a view that was saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the measurements as a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the 3D view as a DICOM presentation state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F5 to F9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four panes, or 3D, axial, coronal, sagittal alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2 to F4, F10, F12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels: studies, transfer function, clip; presets; lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel: segmentations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a study of the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel, Up, Down on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next slice; with Shift, or Page Up and Page Down, five; Home and End: to the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right drag, 1 to 9 on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up; or a customary one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + wheel, middle drag, +, - on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closer, sideways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F, double right click on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole slice, in the middle of its pane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the next pane or control, or back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C, W, Z, M, D, G, E, V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left button on slices: cross-hair, window, zoom, move, distance, angle, ellipse, probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White and black change places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play through all slices, or stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the measurement that is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This pane alone, or all four</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings: language, look, keys, what is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+[ and Ctrl+]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames in motion: faster, or more accurate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the picture at rest until it is final; Esc stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right click, Menu on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Windows, and those of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+1 to Alt+9 on slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A window of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click on a measurement, Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Four Panes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;3D Alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;xial Alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;oronal Alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;gittal Alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>macula::viewer::BackgroundMenu</name>
    <message>
        <source>Back&amp;ground</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Nearly Black</source>
        <translation>&amp;Fast schwarz</translation>
    </message>
    <message>
        <source>As when nobody has chosen; saved pictures are black then</source>
        <translation>Wie wenn niemand gewählt hat; gespeicherte Bilder sind dann schwarz</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Schwarz</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>&amp;Weiß</translation>
    </message>
    <message>
        <source>&amp;Other Colour…</source>
        <translation>&amp;Andere Farbe…</translation>
    </message>
    <message>
        <source>Of what lies behind the patient in the 3D picture, and in pictures saved of it</source>
        <translation>Was im 3D-Bild hinter dem Patienten liegt, auch in Bildern, die davon gespeichert werden</translation>
    </message>
    <message>
        <source>Colour of the background</source>
        <translation>Farbe des Hintergrunds</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
</context>
<context>
    <name>macula::viewer::BrowserController</name>
    <message>
        <source>&amp;Find a Study…</source>
        <translation>Studie &amp;suchen…</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipEditing</name>
    <message>
        <source>Depth of the cut</source>
        <translation>Tiefe des Schnitts</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>The clip has six planes and no more.</source>
        <translation>Der Beschnitt hat sechs Ebenen und nicht mehr.</translation>
    </message>
    <message>
        <source>Remove one of them first, or begin without a clip.</source>
        <translation>Entfernen Sie zuerst eine davon, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Cut from the eye</source>
        <translation>Schnitt vom Auge aus</translation>
    </message>
    <message>
        <source>There are %1 cuts with the scissors, and no more are possible.</source>
        <translation>Es gibt %1 Schnitte mit der Schere, und mehr sind nicht möglich.</translation>
    </message>
    <message>
        <source>Undo one of them first.</source>
        <translation>Machen Sie zuerst einen davon rückgängig.</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Remove cuts</source>
        <translation>Schnitte entfernen</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipPanel</name>
    <message>
        <source>Turn inside out</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Shows what the clip removes, and removes what it shows</source>
        <translation>Zeigt, was der Beschnitt entfernt, und entfernt, was er zeigt</translation>
    </message>
    <message>
        <source>Undo all: no clip</source>
        <translation>Alles zurück: kein Beschnitt</translation>
    </message>
    <message>
        <source>Shows all of the volume again</source>
        <translation>Zeigt wieder das ganze Volumen</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigener</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Where the cross-hair is, in mm of the patient (LPS)</source>
        <translation>Wo das Fadenkreuz ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>At the cross-hair</source>
        <translation>Am Fadenkreuz</translation>
    </message>
    <message>
        <source>Thickness of the slab</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>How thick the slab is, in mm</source>
        <translation>Wie dick der Slab ist, in mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Direction of the slab</source>
        <translation>Richtung des Slabs</translation>
    </message>
    <message>
        <source>Along which slices the slab lies</source>
        <translation>Entlang welcher Schichten der Slab liegt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Which of the eight parts around the cross-hair is meant</source>
        <translation>Welcher der acht Teile um das Fadenkreuz gemeint ist</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>From its centre, in mm</source>
        <translation>Von der Mitte aus, in mm</translation>
    </message>
    <message>
        <source>Remove a ball</source>
        <translation>Kugel entfernen</translation>
    </message>
    <message>
        <source>Removes a ball around the cross-hair; it takes the place of another ball</source>
        <translation>Entfernt eine Kugel um das Fadenkreuz; sie ersetzt eine andere Kugel</translation>
    </message>
    <message>
        <source>Removes that corner; it takes the place of another corner</source>
        <translation>Entfernt diese Ecke; sie ersetzt eine andere Ecke</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Which part of the volume is shown</source>
        <translation>Welcher Teil des Volumens gezeigt wird</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A box is removed.</source>
        <translation>Ein Quader ist entfernt.</translation>
    </message>
    <message>
        <source>Only a turned box is kept.</source>
        <translation>Nur ein gedrehter Quader bleibt.</translation>
    </message>
    <message>
        <source>Oblique planes that cut: %1.</source>
        <translation>Schräge Ebenen, die schneiden: %1.</translation>
    </message>
    <message>
        <source>A corner is removed.</source>
        <translation>Eine Ecke ist entfernt.</translation>
    </message>
    <message>
        <source>A ball is removed.</source>
        <translation>Eine Kugel ist entfernt.</translation>
    </message>
    <message>
        <source>Only a ball is kept.</source>
        <translation>Nur eine Kugel bleibt.</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1, %2, %3 mm</translation>
    </message>
    <message>
        <source>All of the volume is shown.</source>
        <translation>Das ganze Volumen wird gezeigt.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Remove from the cross-hair on</source>
        <translation>Ab dem Fadenkreuz entfernen</translation>
    </message>
    <message>
        <source>remove %1 side</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Removes all that lies %1 of the cross-hair</source>
        <translation>Entfernt alles, was vom Fadenkreuz aus %1 liegt</translation>
    </message>
    <message>
        <source>Keep only a slab</source>
        <translation>Nur einen Slab behalten</translation>
    </message>
    <message>
        <source>Removes all but a slab with the cross-hair in its middle</source>
        <translation>Entfernt alles außer einem Slab mit dem Fadenkreuz in seiner Mitte</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Ecke entfernen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipsController</name>
    <message>
        <source>Cutting</source>
        <translation>Wird geschnitten</translation>
    </message>
    <message>
        <source>&amp;Clip</source>
        <translation>Besch&amp;nitt</translation>
    </message>
    <message>
        <source>&amp;Handles in the Pictures</source>
        <translation>&amp;Griffe in den Bildern</translation>
    </message>
    <message>
        <source>Drag faces, planes and balls of the clip where they are seen</source>
        <translation>Flächen, Ebenen und Kugeln des Beschnitts ziehen, wo sie zu sehen sind</translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation>&amp;Schere</translation>
    </message>
    <message>
        <source>Draw around something in the 3D picture: it is removed. With Shift, all else is</source>
        <translation>Im 3D-Bild etwas umfahren: es wird entfernt. Mit Umschalt alles andere</translation>
    </message>
    <message>
        <source>Cut from the &amp;Eye</source>
        <translation>Schnitt vom &amp;Auge aus</translation>
    </message>
    <message>
        <source>Remove all that lies before a plane across the line of sight</source>
        <translation>Alles entfernen, was vor einer Ebene quer zur Blickrichtung liegt</translation>
    </message>
    <message>
        <source>&amp;No Clip</source>
        <translation>&amp;Kein Beschnitt</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ConvergeNow</name>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Converging was stopped: another picture is shown.</source>
        <translation>Das Fertigzeichnen wurde angehalten: ein anderes Bild wird gezeigt.</translation>
    </message>
    <message>
        <source>Converging</source>
        <translation>Wird fertig gezeichnet</translation>
    </message>
    <message>
        <source>, noise %1</source>
        <translation>, Rauschen %1</translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>, %1 min left</source>
        <translation>, noch %1 min</translation>
    </message>
    <message>
        <source>, %1 h left</source>
        <translation>, noch %1 h</translation>
    </message>
    <message numerus="yes">
        <source>The picture is final: %Ln samples, noise %1 of black to white.</source>
        <translation>
            <numerusform>Das Bild ist endgültig: %Ln Abtastung, Rauschen %1 von Schwarz bis Weiß.</numerusform>
            <numerusform>Das Bild ist endgültig: %Ln Abtastungen, Rauschen %1 von Schwarz bis Weiß.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The picture is final: %Ln samples.</source>
        <translation>
            <numerusform>Das Bild ist endgültig: %Ln Abtastung.</numerusform>
            <numerusform>Das Bild ist endgültig: %Ln Abtastungen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::CutTools</name>
    <message>
        <source>Show clip on slices</source>
        <translation>Beschnitt auf Schichten zeigen</translation>
    </message>
    <message>
        <source>Cut from the eye</source>
        <translation>Schnitt vom Auge aus</translation>
    </message>
    <message>
        <source>Goes with the camera</source>
        <translation>Geht mit der Kamera</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Undo all cuts</source>
        <translation>Alle Schnitte zurück</translation>
    </message>
    <message>
        <source>Before the eye</source>
        <translation>Vor dem Auge</translation>
    </message>
    <message>
        <source>Depth of the cut from the eye, in mm</source>
        <translation>Tiefe des Schnitts vom Auge aus, in mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The cut goes with the camera</source>
        <translation>Der Schnitt geht mit der Kamera</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Scissors over the 3D picture</source>
        <translation>Schere über dem 3D-Bild</translation>
    </message>
    <message>
        <source>Undo all cuts with the scissors</source>
        <translation>Alle Schnitte mit der Schere zurücknehmen</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Slices show dark what the clip removes, and its borders as lines</source>
        <translation>Schichten zeigen dunkel, was der Beschnitt entfernt, und seine Grenzen als Linien</translation>
    </message>
    <message>
        <source>Removes all that lies before a plane across the line of sight, at the cross-hair</source>
        <translation>Entfernt alles, was vor einer Ebene quer zur Blickrichtung am Fadenkreuz liegt</translation>
    </message>
    <message>
        <source>From the middle of the volume, in mm; below 0 is nearer to the eye. In the picture: Shift + wheel</source>
        <translation>Von der Mitte des Volumens, in mm; unter 0 ist näher am Auge. Im Bild: Umschalt + Rad</translation>
    </message>
    <message>
        <source>The plane stays across the line of sight; else it stays in the patient</source>
        <translation>Die Ebene bleibt quer zur Blickrichtung; sonst bleibt sie im Patienten</translation>
    </message>
    <message>
        <source>Draw around something in the 3D picture: it is removed. With Shift, all else is</source>
        <translation>Im 3D-Bild etwas umfahren: es wird entfernt. Mit Umschalt alles andere</translation>
    </message>
    <message>
        <source>Shows again what the scissors removed</source>
        <translation>Zeigt wieder, was die Schere entfernt hat</translation>
    </message>
    <message>
        <source>The clip has six planes: the cut from the eye is not shown.</source>
        <translation>Der Beschnitt hat sechs Ebenen: der Schnitt vom Auge aus wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>There is no cut from the eye.</source>
        <translation>Es gibt keinen Schnitt vom Auge aus.</translation>
    </message>
    <message>
        <source>Nothing is cut with the scissors.</source>
        <translation>Mit der Schere ist nichts geschnitten.</translation>
    </message>
    <message>
        <source>Cuts: %1</source>
        <translation>Schnitte: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FaceRow</name>
    <message>
        <source>Clip face, %1, slider</source>
        <translation>Schnittfläche %1, Schieber</translation>
    </message>
    <message>
        <source>Clip face, %1, in mm</source>
        <translation>Schnittfläche %1, in mm</translation>
    </message>
    <message>
        <source>Open the clip face, %1</source>
        <translation>Schnittfläche %1 öffnen</translation>
    </message>
    <message>
        <source>Where the %1 face of what is shown is, in mm of the patient (LPS)</source>
        <translation>Wo die Fläche %1 des Gezeigten ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Show all of the volume on the %1 side again</source>
        <translation>Auf der Seite %1 wieder das ganze Volumen zeigen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FidelityBadge</name>
    <message>
        <source>Final</source>
        <translation>Endgültig</translation>
    </message>
    <message>
        <source>Preliminary</source>
        <translation>Vorläufig</translation>
    </message>
    <message>
        <source>Nothing will change any more</source>
        <translation>Es ändert sich nichts mehr</translation>
    </message>
    <message>
        <source>The picture gets better</source>
        <translation>Das Bild wird noch besser</translation>
    </message>
</context>
<context>
    <name>macula::viewer::HeadsetController</name>
    <message>
        <source>Looking for the headset</source>
        <translation>Das Headset wird gesucht</translation>
    </message>
    <message>
        <source>Show in &amp;Headset</source>
        <translation>Im &amp;Headset zeigen</translation>
    </message>
    <message>
        <source>This study in a headset (OpenXR), to be held, turned and cut by hand</source>
        <translation>Diese Studie in einem Headset (OpenXR), mit der Hand zu halten, zu drehen und zu schneiden</translation>
    </message>
    <message>
        <source>There is nothing to show in a headset yet.</source>
        <translation>Es gibt noch nichts, was im Headset gezeigt werden kann.</translation>
    </message>
    <message>
        <source>In the headset</source>
        <translation>Im Headset</translation>
    </message>
</context>
<context>
    <name>macula::viewer::HeadsetMirror</name>
    <message>
        <source>Patient and study</source>
        <translation>Patient und Studie</translation>
    </message>
    <message>
        <source>What the left eye sees in the headset</source>
        <translation>Was das linke Auge im Headset sieht</translation>
    </message>
    <message>
        <source>Whose study is in the headset, above the mirror; off at each start</source>
        <translation>Wessen Studie im Headset ist, über dem Spiegelbild; bei jedem Start aus</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Show in Headset</source>
        <translation>Im Headset zeigen</translation>
    </message>
    <message>
        <source>End the session in the headset; the window goes on</source>
        <translation>Die Sitzung im Headset beenden; das Fenster läuft weiter</translation>
    </message>
    <message>
        <source>The study of this window in a headset (OpenXR)</source>
        <translation>Die Studie dieses Fensters in einem Headset (OpenXR)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::KeysPage</name>
    <message>
        <source>&amp;No Key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Usual Key</source>
        <translation>&amp;Übliche Taste</translation>
    </message>
    <message>
        <source>&amp;All as Usual</source>
        <translation>&amp;Alle wie üblich</translation>
    </message>
    <message>
        <source>Search the actions and keys</source>
        <translation>Befehle und Tasten durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Words of an action, or a key such as F3</source>
        <translation>Wörter eines Befehls oder eine Taste wie F3</translation>
    </message>
    <message>
        <source>New key of the selected action</source>
        <translation>Neue Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Press the new key of the selected action, with Ctrl, Shift or Alt where wanted</source>
        <translation>Drücken Sie die neue Taste des gewählten Befehls, bei Bedarf mit Strg, Umschalt oder Alt</translation>
    </message>
    <message>
        <source>The selected action has no key</source>
        <translation>Der gewählte Befehl hat keine Taste</translation>
    </message>
    <message>
        <source>The selected action has the key again that it came with</source>
        <translation>Der gewählte Befehl hat wieder die mitgelieferte Taste</translation>
    </message>
    <message>
        <source>All actions have the keys again that they came with</source>
        <translation>Alle Befehle haben wieder die mitgelieferten Tasten</translation>
    </message>
    <message>
        <source>What the mouse does, and arrows, digits and letters on slices, is fixed: F1 shows it.</source>
        <translation>Was die Maus tut, und Pfeile, Ziffern und Buchstaben auf Schichten, steht fest: F1 zeigt es.</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>What the window can do, and the key for it; those you have changed are bold</source>
        <translation>Was das Fenster kann und die Taste dafür; fett ist, was Sie geändert haben</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LabelEditor</name>
    <message>
        <source>Label of the measurement</source>
        <translation>Beschriftung der Messung</translation>
    </message>
    <message>
        <source>Label of the measurement. Enter keeps it, Esc leaves it as it was</source>
        <translation>Beschriftung der Messung. Eingabe behält sie, Esc lässt sie, wie sie war</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsController</name>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>  Lights </source>
        <translation>  Beleuchtung </translation>
    </message>
    <message>
        <source>Where the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear have lights</source>
        <translation>Nur Cinematic und Klar haben eine Beleuchtung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsDesk</name>
    <message>
        <source>Save the lights</source>
        <translation>Lichter speichern</translation>
    </message>
    <message>
        <source>Lights (*.json)</source>
        <translation>Lichter (*.json)</translation>
    </message>
    <message>
        <source>The lights are written to %1. Use them with --lights %1.</source>
        <translation>Die Lichter sind nach %1 geschrieben. Verwenden Sie sie mit --lights %1.</translation>
    </message>
    <message>
        <source>Open lights</source>
        <translation>Lichter öffnen</translation>
    </message>
    <message>
        <source>Lights (*.json);;All files (*)</source>
        <translation>Lichter (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsEditing</name>
    <message>
        <source>There is no light that could be changed.</source>
        <translation>Es gibt kein Licht, das geändert werden könnte.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Add a light first.</source>
        <translation>Fügen Sie zuerst ein Licht hinzu.</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear have lights.</source>
        <translation>Nur Cinematic und Klar haben Lichter.</translation>
    </message>
    <message>
        <source>Open a study, and choose one of these looks.</source>
        <translation>Öffnen Sie eine Studie und wählen Sie eine dieser Darstellungen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsPanel</name>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open lights of a file</source>
        <translation>Lichter aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Lights that were saved here, or a light rig of your own (JSON)</source>
        <translation>Lichter, die hier gespeichert wurden, oder eine eigene Anordnung (JSON)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the lights to a file</source>
        <translation>Lichter in einer Datei speichern</translation>
    </message>
    <message>
        <source>For other studies, and for --lights</source>
        <translation>Für andere Studien und für --lights</translation>
    </message>
    <message>
        <source>One light: drag it in the picture</source>
        <translation>Ein Licht: im Bild zu ziehen</translation>
    </message>
    <message>
        <source>Which light</source>
        <translation>Welches Licht</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Ein Licht hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this light</source>
        <translation>Dieses Licht entfernen</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Radiance of the disc; in the picture Shift and the wheel</source>
        <translation>Strahldichte der Scheibe; im Bild Umschalt und Mausrad</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of this light</source>
        <translation>Farbe dieses Lichts</translation>
    </message>
    <message>
        <source>All lights</source>
        <translation>Alle Lichter</translation>
    </message>
    <message>
        <source>What the lights keep to</source>
        <translation>Woran sich die Lichter halten</translation>
    </message>
    <message>
        <source>the patient</source>
        <translation>am Patienten</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>an der Kamera</translation>
    </message>
    <message>
        <source>Lights that keep to the camera leave the preview in motion without a model</source>
        <translation>Mit Lichtern an der Kamera hat die Vorschau in Bewegung kein Modell</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Light from everywhere: less shows more relief, more shows what lies in shadow</source>
        <translation>Licht von überall: weniger zeigt mehr Relief, mehr zeigt, was im Schatten liegt</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Strength of all</source>
        <translation>Stärke aller</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Find the exposure</source>
        <translation>Belichtung finden</translation>
    </message>
    <message>
        <source>Once, for what is seen now, as a camera does; it stays until it is changed</source>
        <translation>Einmal, für das, was jetzt zu sehen ist, wie eine Kamera; sie bleibt, bis sie geändert wird</translation>
    </message>
    <message>
        <source>Keep to</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Farbe des Lichts</translation>
    </message>
    <message>
        <source>Light %1</source>
        <translation>Licht %1</translation>
    </message>
    <message>
        <source>Where the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>The light that the numbers below are of</source>
        <translation>Das Licht, zu dem die Zahlen darunter gehören</translation>
    </message>
    <message>
        <source>One more light, from above the viewer&apos;s left shoulder</source>
        <translation>Ein weiteres Licht, von über der linken Schulter des Betrachters</translation>
    </message>
    <message>
        <source>Take the chosen light out of the rig</source>
        <translation>Das gewählte Licht entfernen</translation>
    </message>
    <message>
        <source>In °: 0 is anterior, or the viewer; positive to the patient&apos;s left, or to the right of the picture</source>
        <translation>In °: 0 ist vorn oder der Betrachter; positiv nach links des Patienten oder nach rechts im Bild</translation>
    </message>
    <message>
        <source>In °: positive is superior, or up in the picture</source>
        <translation>In °: positiv ist oben am Patienten oder oben im Bild</translation>
    </message>
    <message>
        <source>Of the disc on the sky, in °: smaller is harder, with sharper shadows and highlights</source>
        <translation>Der Scheibe am Himmel, in °: kleiner ist härter, mit schärferen Schatten und Glanzlichtern</translation>
    </message>
    <message>
        <source>Choose the colour of this light (sRGB); its strength is a number of its own</source>
        <translation>Die Farbe dieses Lichts wählen (sRGB); seine Stärke ist eine eigene Zahl</translation>
    </message>
    <message>
        <source>All lights about the vertical, in °; positive to the patient&apos;s left</source>
        <translation>Alle Lichter um die Senkrechte, in °; positiv nach links des Patienten</translation>
    </message>
    <message>
        <source>Multiplies all lights and the sky</source>
        <translation>Vervielfacht alle Lichter und den Himmel</translation>
    </message>
    <message>
        <source>Multiplies the picture before the tone map</source>
        <translation>Vervielfacht das Bild vor der Tonwertkurve</translation>
    </message>
    <message>
        <source>Rig of lights</source>
        <translation>Anordnung der Lichter</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LookController</name>
    <message>
        <source>&amp;Look</source>
        <translation>Dar&amp;stellung</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>&amp;Shade Ray Cast</source>
        <translation>Volumen-Rendering &amp;schattieren</translation>
    </message>
    <message>
        <source>Light ray casts from the eye, as much as the preset says</source>
        <translation>Volumen-Rendering vom Auge aus beleuchten, so viel die Voreinstellung vorgibt</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
    <message>
        <source>Values between eight voxels, as other viewers show them</source>
        <translation>Werte zwischen acht Voxeln, wie andere Betrachter sie zeigen</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glatt</translation>
    </message>
    <message>
        <source>Fewest rings on skin and bone, and a voxel softer</source>
        <translation>Die wenigsten Ringe auf Haut und Knochen, und ein Voxel weicher</translation>
    </message>
    <message>
        <source>S&amp;harp</source>
        <translation>&amp;Scharf</translation>
    </message>
    <message>
        <source>Fine detail as with Linear, and somewhat fewer rings</source>
        <translation>Feine Einzelheiten wie bei Linear, und etwas weniger Ringe</translation>
    </message>
    <message>
        <source>Between &amp;Voxels</source>
        <translation>Zwischen &amp;Voxeln</translation>
    </message>
    <message>
        <source>Values between voxels</source>
        <translation>Werte zwischen Voxeln</translation>
    </message>
    <message>
        <source>Keep &amp;Hues of Highlights</source>
        <translation>Farbtöne &amp;heller Stellen erhalten</translation>
    </message>
    <message>
        <source>What is too bright for the screen bleaches in its own hue; without it, contrast is higher. Not of projections</source>
        <translation>Was zu hell für den Bildschirm ist, verblasst in seinem eigenen Farbton; ohne dies ist der Kontrast höher. Nicht bei Projektionen</translation>
    </message>
    <message>
        <source>Hues of highlights</source>
        <translation>Farbtöne heller Stellen</translation>
    </message>
    <message>
        <source>Reset &amp;Window</source>
        <translation>&amp;Fensterung zurücksetzen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Of the values: that of the series</source>
        <translation>Der Werte: die der Serie</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MainWindow</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;About Macula</source>
        <translation>&amp;Über Macula</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Patient and study over the picture</source>
        <translation>Patient und Studie über dem Bild</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Transfer Function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>Headset</source>
        <translation>Headset</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MatterFields</name>
    <message>
        <source> per mm</source>
        <translation> je mm</translation>
    </message>
    <message>
        <source> %1/mm</source>
        <translation> %1/mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MeasurementsController</name>
    <message>
        <source>Save &amp;Measurements…</source>
        <translation>&amp;Messungen speichern…</translation>
    </message>
    <message>
        <source>As a table (CSV) or JSON, in mm, degrees and the unit of the study</source>
        <translation>Als Tabelle (CSV) oder JSON, in mm, Grad und der Einheit der Studie</translation>
    </message>
    <message>
        <source>Remove All &amp;Measurements</source>
        <translation>Alle &amp;Messungen entfernen</translation>
    </message>
    <message>
        <source>Remove measurements</source>
        <translation>Messungen entfernen</translation>
    </message>
    <message>
        <source>There are no measurements to save.</source>
        <translation>Es gibt keine Messungen zu speichern.</translation>
    </message>
    <message>
        <source>Measure something on a slice first.</source>
        <translation>Messen Sie zuerst etwas auf einer Schicht.</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tabelle (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>The measurements are written to %1.</source>
        <translation>Die Messungen sind in %1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MessageBar</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ModelExport</name>
    <message>
        <source>The model is written to %1.</source>
        <translation>Das Modell ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source> It holds pictures of the study.</source>
        <translation> Es enthält Bilder der Studie.</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear in lights that stay in place have one. Wait until the status line says that it learns.</source>
        <translation>Nur Cinematic und Klar in einer Beleuchtung, die an ihrem Ort bleibt, haben eines. Warten Sie, bis die Statuszeile sagt, dass es lernt.</translation>
    </message>
    <message numerus="yes">
        <source> %Ln of its Gaussians have numbers that this format cannot hold; they were limited.</source>
        <translation>
            <numerusform> %Ln seiner Gaußfunktionen hat Zahlen, die dieses Format nicht fassen kann; sie wurden begrenzt.</numerusform>
            <numerusform> %Ln seiner Gaußfunktionen haben Zahlen, die dieses Format nicht fassen kann; sie wurden begrenzt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no model of this picture.</source>
        <translation>Von diesem Bild gibt es kein Modell.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ModelsController</name>
    <message>
        <source>glTF, for other programs (*.glb)</source>
        <translation>glTF, für andere Programme (*.glb)</translation>
    </message>
    <message>
        <source>PLY, for other programs (*.ply)</source>
        <translation>PLY, für andere Programme (*.ply)</translation>
    </message>
    <message>
        <source>PLY, exact, in linear light (*.ply)</source>
        <translation>PLY, genau, in linearem Licht (*.ply)</translation>
    </message>
    <message>
        <source>SPZ, small, for other programs (*.spz)</source>
        <translation>SPZ, klein, für andere Programme (*.spz)</translation>
    </message>
    <message>
        <source>Training that can go on, with its pictures (*.macula)</source>
        <translation>Training, das weitergehen kann, mit seinen Bildern (*.macula)</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>Save Mo&amp;del…</source>
        <translation>Mode&amp;ll speichern…</translation>
    </message>
    <message>
        <source>The preview as a model in mm of the patient (3D Gaussians), for this and other programs</source>
        <translation>Die Vorschau als Modell in mm des Patienten (3D-Gaußfunktionen), für dieses und andere Programme</translation>
    </message>
    <message>
        <source>A model is still being written.</source>
        <translation>Ein Modell wird noch geschrieben.</translation>
    </message>
    <message>
        <source>There is no model to save yet.</source>
        <translation>Es gibt noch kein Modell zu speichern.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Modell speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MovieExport</name>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>, %1 min left</source>
        <translation>, noch %1 min</translation>
    </message>
    <message>
        <source>Encoding the video</source>
        <translation>Das Video wird kodiert</translation>
    </message>
    <message>
        <source>The video is %1.</source>
        <translation>Das Video ist %1.</translation>
    </message>
    <message>
        <source>The encoder made no video of them: take another program for that.</source>
        <translation>Der Encoder hat daraus kein Video gemacht: verwenden Sie dafür ein anderes Programm.</translation>
    </message>
    <message>
        <source>The video was stopped.</source>
        <translation>Das Video wurde angehalten.</translation>
    </message>
    <message>
        <source>No video was made of them: there is no encoder. Install ffmpeg, and draw again.</source>
        <translation>Daraus wurde kein Video gemacht: es gibt keinen Encoder. Installieren Sie ffmpeg, und zeichnen Sie noch einmal.</translation>
    </message>
    <message>
        <source>No video was made of them: %1 is there already.</source>
        <translation>Daraus wurde kein Video gemacht: %1 gibt es schon.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures are in %1.</source>
        <translation>
            <numerusform>%Ln Bild ist in %1.</numerusform>
            <numerusform>%Ln Bilder sind in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::MoviePanel</name>
    <message>
        <source>%1, %2 to %3%4</source>
        <translation>%1, %2 bis %3%4</translation>
    </message>
    <message>
        <source>&amp;Draw Movie…</source>
        <translation>Film &amp;zeichnen…</translation>
    </message>
    <message>
        <source>Draw all pictures to a folder, while the window goes on</source>
        <translation>Alle Bilder in einen Ordner zeichnen, während das Fenster weitergeht</translation>
    </message>
    <message>
        <source>How the camera goes</source>
        <translation>Wie die Kamera geht</translation>
    </message>
    <message>
        <source>Around the patient from here, or along views that are added</source>
        <translation>Von hier um den Patienten herum oder entlang hinzugefügter Ansichten</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Umrundung</translation>
    </message>
    <message>
        <source>Along views</source>
        <translation>Entlang von Ansichten</translation>
    </message>
    <message>
        <source>Degrees around the patient</source>
        <translation>Grad um den Patienten</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>More samples per pixel: less noise, and more time</source>
        <translation>Mehr Abtastungen je Pixel: weniger Rauschen und mehr Zeit</translation>
    </message>
    <message>
        <source>Sides of the &amp;patient</source>
        <translation>Seiten des &amp;Patienten</translation>
    </message>
    <message>
        <source>Letters at the edges of each picture</source>
        <translation>Buchstaben an den Rändern jedes Bildes</translation>
    </message>
    <message>
        <source>&amp;Name patient and study</source>
        <translation>Patient und Studie &amp;nennen</translation>
    </message>
    <message>
        <source>Over each picture, as in the window. Without it nobody is named; a face can still be seen</source>
        <translation>Über jedem Bild, wie im Fenster. Ohne das wird niemand genannt; ein Gesicht ist trotzdem zu erkennen</translation>
    </message>
    <message>
        <source>&amp;Video of them</source>
        <translation>&amp;Video daraus</translation>
    </message>
    <message>
        <source>An MP4 file beside them, by ffmpeg if it is installed</source>
        <translation>Eine MP4-Datei daneben, mit ffmpeg, wenn es installiert ist</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>De&amp;grees</source>
        <translation>&amp;Grad</translation>
    </message>
    <message>
        <source>&amp;Seconds</source>
        <translation>&amp;Sekunden</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Views of the way</source>
        <translation>Ansichten der Kamerafahrt</translation>
    </message>
    <message>
        <source>The camera goes smoothly from each to the next</source>
        <translation>Die Kamera geht gleitend von jeder zur nächsten</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>&amp;Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>What is looked at now, 2 s after the view before</source>
        <translation>Was jetzt zu sehen ist, 2 s nach der Ansicht davor</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Leave out the view that is chosen</source>
        <translation>Die gewählte Ansicht weglassen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>A way from a file, as of macula hybrid --path</source>
        <translation>Eine Kamerafahrt aus einer Datei, wie von macula hybrid --path</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>The way to a file, for macula hybrid --path</source>
        <translation>Die Kamerafahrt in eine Datei, für macula hybrid --path</translation>
    </message>
    <message>
        <source>View %1, at %L2 s</source>
        <translation>Ansicht %1, bei %L2 s</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln Bild</numerusform>
            <numerusform>%Ln Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>This machine has no encoder: install ffmpeg for a video. Pictures are drawn to the folder all the same.</source>
        <translation>Dieser Rechner hat keinen Encoder: für ein Video installieren Sie ffmpeg. Die Bilder werden trotzdem in den Ordner gezeichnet.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MoviesController</name>
    <message>
        <source>Drawing the movie</source>
        <translation>Der Film wird gezeichnet</translation>
    </message>
    <message>
        <source>Save Mo&amp;vie…</source>
        <translation>F&amp;ilm speichern…</translation>
    </message>
    <message>
        <source>A turntable or a way of the camera as pictures, and as a video</source>
        <translation>Eine Umrundung oder Kamerafahrt als Bilder und als Video</translation>
    </message>
    <message>
        <source>A movie is still being drawn.</source>
        <translation>Ein Film wird noch gezeichnet.</translation>
    </message>
    <message>
        <source>There is nothing to draw yet.</source>
        <translation>Es gibt noch nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Choose a folder for the pictures</source>
        <translation>Ordner für die Bilder wählen</translation>
    </message>
    <message>
        <source>Open a way of the camera</source>
        <translation>Kamerafahrt öffnen</translation>
    </message>
    <message>
        <source>Ways (*.json)</source>
        <translation>Kamerafahrten (*.json)</translation>
    </message>
    <message>
        <source>Save the way of the camera</source>
        <translation>Kamerafahrt speichern</translation>
    </message>
    <message>
        <source>The way is written to %1. macula hybrid draws it with --path %1.</source>
        <translation>Die Kamerafahrt ist in %1 gespeichert. macula hybrid zeichnet sie mit --path %1.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::NamedClips</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Clips of this study</source>
        <translation>Beschnitte dieser Studie</translation>
    </message>
    <message>
        <source>Name of a clip</source>
        <translation>Name eines Beschnitts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type a name first.</source>
        <translation>Geben Sie zuerst einen Namen ein.</translation>
    </message>
    <message>
        <source>There are %1 clips, and no more are possible. Delete one first.</source>
        <translation>Es gibt %1 Beschnitte, und mehr sind nicht möglich. Löschen Sie zuerst einen.</translation>
    </message>
    <message>
        <source>Save clip</source>
        <translation>Beschnitt speichern</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Another clip has that name. Take another one.</source>
        <translation>Ein anderer Beschnitt heißt so. Nehmen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Rename clip</source>
        <translation>Beschnitt umbenennen</translation>
    </message>
    <message>
        <source>Delete clip</source>
        <translation>Beschnitt löschen</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Choose a clip of the list first.</source>
        <translation>Wählen Sie zuerst einen Beschnitt aus der Liste.</translation>
    </message>
    <message>
        <source>Double click shows one again</source>
        <translation>Doppelklick zeigt einen wieder</translation>
    </message>
    <message>
        <source>What the clip is called; it is kept with the study</source>
        <translation>Wie der Beschnitt heißt; er wird mit der Studie aufbewahrt</translation>
    </message>
    <message>
        <source>Keeps what is clipped and cut now under that name</source>
        <translation>Behält unter diesem Namen, was jetzt beschnitten und geschnitten ist</translation>
    </message>
    <message>
        <source>Clips as it was when that was saved</source>
        <translation>Beschneidet, wie es beim Speichern war</translation>
    </message>
    <message>
        <source>Gives the chosen clip the name that is typed</source>
        <translation>Gibt dem gewählten Beschnitt den eingegebenen Namen</translation>
    </message>
    <message>
        <source>Deletes the chosen clip from the list; what is shown stays</source>
        <translation>Löscht den gewählten Beschnitt aus der Liste; das Gezeigte bleibt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::Notifications</name>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::OpeningController</name>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Only one folder or file can be opened at a time.</source>
        <translation>Es kann nur ein Ordner oder eine Datei auf einmal geöffnet werden.</translation>
    </message>
    <message>
        <source>Drop one of them, or the folder that holds them all.</source>
        <translation>Legen Sie einen davon ab, oder den Ordner, in dem alle sind.</translation>
    </message>
    <message>
        <source>&amp;Open Folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open the best volume in a folder of DICOM files</source>
        <translation>Das beste Volumen eines Ordners mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open &amp;File…</source>
        <translation>&amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>Open the series of an image, a DICOMDIR, or a NIfTI, NRRD or MetaImage file</source>
        <translation>Die Serie eines Bildes, ein DICOMDIR oder eine NIfTI-, NRRD- oder MetaImage-Datei öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Phantom</source>
        <translation>&amp;Phantom öffnen</translation>
    </message>
    <message>
        <source>Open the built-in phantom study</source>
        <translation>Die eingebaute Phantomstudie öffnen</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ordner mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open an image or a volume</source>
        <translation>Bild oder Volumen öffnen</translation>
    </message>
    <message>
        <source>What is on screen is still of the study that was open before.</source>
        <translation>Auf dem Bildschirm ist noch die Studie, die vorher offen war.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::OwnWindowList</name>
    <message>
        <source>Windows of your own that were kept cannot be read.</source>
        <translation>Behaltene eigene Fensterungen können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The next one that you keep takes their place.</source>
        <translation>Die nächste, die Sie behalten, tritt an ihre Stelle.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PanelsController</name>
    <message>
        <source>Panels that share this place</source>
        <translation>Bereiche, die sich diesen Platz teilen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PanesController</name>
    <message>
        <source>Panes</source>
        <translation>Bildfelder</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PatientMmBox</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PickController</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureCurtain</name>
    <message>
        <source>Both pictures</source>
        <translation>Beide Bilder</translation>
    </message>
    <message>
        <source>Drag the line between the two presets</source>
        <translation>Die Linie zwischen den beiden Voreinstellungen ziehen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice the screen</source>
        <translation>Zweimal der Bildschirm</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>More samples per pixel: less noise, and more time</source>
        <translation>Mehr Abtastungen je Pixel: weniger Rauschen und mehr Zeit</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Diameter in mm: what the middle of the picture shows is sharp, what is nearer or farther is blurred. Not of ray casts and projections</source>
        <translation>Durchmesser in mm: Scharf ist, was die Bildmitte zeigt; was näher oder ferner ist, wird unscharf. Nicht bei Volumen-Rendering und Projektionen</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>What lies behind the nearest matter fades into the background, to 37 % over so many mm. Not of projections</source>
        <translation>Was hinter der nächsten Materie liegt, verblasst in den Hintergrund, auf 37 % in so vielen mm. Nicht bei Projektionen</translation>
    </message>
    <message>
        <source>&amp;Lens</source>
        <translation>&amp;Linse</translation>
    </message>
    <message>
        <source>&amp;Fog</source>
        <translation>&amp;Nebel</translation>
    </message>
    <message>
        <source>Of DICOM files: nothing of the patient is written, and all UIDs are new. Other files never name anybody. A face can still be seen.</source>
        <translation>Bei DICOM-Dateien: vom Patienten wird nichts geschrieben, und alle UIDs sind neu. Andere Dateien nennen nie jemanden. Ein Gesicht ist trotzdem zu erkennen.</translation>
    </message>
    <message>
        <source>&amp;Choose File…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>A usual size in pixels; any other below</source>
        <translation>Eine übliche Größe in Pixeln; jede andere darunter</translation>
    </message>
    <message>
        <source>Choose where the picture is saved; then it is drawn</source>
        <translation>Wählen, wo das Bild gespeichert wird; dann wird es gezeichnet</translation>
    </message>
    <message>
        <source>Save no picture</source>
        <translation>Kein Bild speichern</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Abtastung</numerusform>
            <numerusform>%n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>With &amp;cube, scale and letters</source>
        <translation>Mit &amp;Würfel, Maßstab und Buchstaben</translation>
    </message>
    <message>
        <source>From where the patient is seen, and how many mm or cm something is long, over the picture. Pictures of light (EXR) have none. Nobody is named</source>
        <translation>Von wo der Patient gesehen wird, und wie viele mm oder cm etwas lang ist, über dem Bild. Bilder aus Licht (EXR) haben keine. Niemand wird genannt</translation>
    </message>
    <message>
        <source>The view in 3D is drawn, which is not shown now. Slices are not saved as pictures.</source>
        <translation>Gezeichnet wird die Ansicht in 3D, die gerade nicht gezeigt wird. Schichten werden nicht als Bilder gespeichert.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PicturesController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>The picture is written to %1.</source>
        <translation>Das Bild ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Draw what is seen in 3D at any size and quality, without names</source>
        <translation>Zeichnet, was in 3D zu sehen ist, in jeder Größe und Qualität, ohne Namen</translation>
    </message>
    <message>
        <source>A picture is still being drawn.</source>
        <translation>Ein Bild wird noch gezeichnet.</translation>
    </message>
    <message>
        <source>There is no picture to save yet.</source>
        <translation>Es gibt noch kein Bild zu speichern.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)</source>
        <translation>Bilder (*.png);;Lineares Licht und Tiefe (*.exr);;DICOM Secondary Capture (*.dcm)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PointFields</name>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punkts</translation>
    </message>
    <message>
        <source>Choose the colour of the selected colour point (sRGB)</source>
        <translation>Die Farbe des gewählten Farbpunkts wählen (sRGB)</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Value of the selected point, in the scanner&apos;s own numbers</source>
        <translation>Wert des gewählten Punkts, in Zahlen des Geräts</translation>
    </message>
    <message>
        <source>Value of the selected point, in %1</source>
        <translation>Wert des gewählten Punkts, in %1</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1, of a layer %1 mm thick</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1, einer %1 mm dicken Lage</translation>
    </message>
    <message>
        <source>Colour of the point</source>
        <translation>Farbe des Punkts</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresentationDialog</name>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Save Presentation State</source>
        <translation>Presentation State speichern</translation>
    </message>
    <message>
        <source>A DICOM object without pixels, for the archive: camera, colours, clip and shading of the 3D view. Macula draws the same picture of it; other programs draw what they can.</source>
        <translation>Ein DICOM-Objekt ohne Pixel, für das Archiv: Kamera, Farben, Beschnitt und Schattierung der 3D-Ansicht. Macula zeichnet daraus dasselbe Bild; andere Programme zeichnen, was sie können.</translation>
    </message>
    <message>
        <source>Without patient and study</source>
        <translation>Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Nothing of the patient is written, and all UIDs are other ones. It can be opened where the series itself is.</source>
        <translation>Vom Patienten wird nichts geschrieben, und alle UIDs sind andere. Es kann geöffnet werden, wo die Serie selbst ist.</translation>
    </message>
    <message>
        <source>&amp;Choose File…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresentationsController</name>
    <message>
        <source>The presentation state is written to %1.</source>
        <translation>Der Presentation State ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Open Presen&amp;tation State…</source>
        <translation>Presen&amp;tation State öffnen…</translation>
    </message>
    <message>
        <source>Show this series as a DICOM presentation state says</source>
        <translation>Diese Serie zeigen, wie ein DICOM Presentation State es angibt</translation>
    </message>
    <message>
        <source>Save Presentation State…</source>
        <translation>Presentation State speichern…</translation>
    </message>
    <message>
        <source>The 3D view as a DICOM object, for the archive and other programs</source>
        <translation>Die 3D-Ansicht als DICOM-Objekt, für das Archiv und andere Programme</translation>
    </message>
    <message>
        <source>A presentation state is still being written.</source>
        <translation>Ein Presentation State wird noch geschrieben.</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the series of the presentation state first.</source>
        <translation>Öffnen Sie zuerst die Serie des Presentation State.</translation>
    </message>
    <message>
        <source>Open a presentation state</source>
        <translation>Presentation State öffnen</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm);;All files (*)</source>
        <translation>DICOM-Dateien (*.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose another one, or open the folder that its series is in.</source>
        <translation>Wählen Sie einen anderen, oder öffnen Sie den Ordner mit der Serie dazu.</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images, and none are open.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder, und keine sind offen.</translation>
    </message>
    <message>
        <source>Open a folder with DICOM files, or save the view.</source>
        <translation>Öffnen Sie einen Ordner mit DICOM-Dateien, oder speichern Sie die Ansicht.</translation>
    </message>
    <message>
        <source>Save the presentation state</source>
        <translation>Presentation State speichern</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm)</source>
        <translation>DICOM-Dateien (*.dcm)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetBox</name>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetComparison</name>
    <message>
        <source>&amp;Beside each other</source>
        <translation>&amp;Nebeneinander</translation>
    </message>
    <message>
        <source>Compare presets</source>
        <translation>Voreinstellungen vergleichen</translation>
    </message>
    <message>
        <source>Where the two pictures meet</source>
        <translation>Wo die beiden Bilder sich treffen</translation>
    </message>
    <message>
        <source>Where the two pictures meet, from left to right</source>
        <translation>Wo die beiden Bilder sich treffen, von links nach rechts</translation>
    </message>
    <message>
        <source>Each picture as a whole, instead of one line between them</source>
        <translation>Jedes Bild als Ganzes, statt einer Linie dazwischen</translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;verwenden</translation>
    </message>
    <message>
        <source>Show the volume with the preset at the right; can be undone</source>
        <translation>Das Volumen mit der rechten Voreinstellung zeigen; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Drawing both</source>
        <translation>Beide werden gezeichnet</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetGallery</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Put the deleted preset back</source>
        <translation>Die gelöschte Voreinstellung zurückholen</translation>
    </message>
    <message>
        <source>The preset that was deleted last comes back as it was</source>
        <translation>Die zuletzt gelöschte Voreinstellung kommt zurück, wie sie war</translation>
    </message>
    <message>
        <source>Filter the presets</source>
        <translation>Voreinstellungen filtern</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Part of a name or a kind of image; Down or Enter goes to the presets, Esc ends it</source>
        <translation>Teil eines Namens oder eine Bildart; Ab oder Eingabe geht zu den Voreinstellungen, Esc beendet es</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep or import a preset of your own</source>
        <translation>Eigene Voreinstellung behalten oder importieren</translation>
    </message>
    <message>
        <source>Keep the curve, or all that is seen, as a preset of your own; or import one</source>
        <translation>Die Kurve oder alles Gezeigte als eigene Voreinstellung behalten, oder eine importieren</translation>
    </message>
    <message>
        <source>Keep the &amp;Curve…</source>
        <translation>&amp;Kurve behalten…</translation>
    </message>
    <message>
        <source>The transfer function that is shown</source>
        <translation>Die gezeigte Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Keep All That Is &amp;Seen…</source>
        <translation>Alles &amp;Gezeigte behalten…</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, for other studies too</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, auch für andere Studien</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX</source>
        <translation>Von Macula, 3D Slicer, ParaView, VolView, MITK, Horos oder OsiriX</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Each preset as it shows this volume, from anterior and coarse. A double click or Enter uses it.</source>
        <translation>Jede Voreinstellung, wie sie dieses Volumen zeigt, von anterior und grob. Ein Doppelklick oder Eingabe verwendet sie.</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>Keine Voreinstellung passt zu „%1“.</translation>
    </message>
    <message>
        <source>“%1” is deleted.</source>
        <translation>„%1“ ist gelöscht.</translation>
    </message>
    <message>
        <source>There is nothing in this volume to draw small pictures of.</source>
        <translation>In diesem Volumen ist nichts, wovon kleine Bilder gezeichnet werden könnten.</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Compare with What Is Shown…</source>
        <translation>Mit dem Ge&amp;zeigten vergleichen…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favorit</translation>
    </message>
    <message>
        <source>Save as C&amp;opy…</source>
        <translation>Als &amp;Kopie speichern…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Built-in presets are never changed: save a copy</source>
        <translation>Eingebaute Voreinstellungen ändern sich nie: eine Kopie speichern</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>The curve, as a file for --preset and 3D Slicer</source>
        <translation>Die Kurve, als Datei für --preset und 3D Slicer</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetLibrary</name>
    <message>
        <source>Your presets could not be read: %1</source>
        <translation>Ihre Voreinstellungen konnten nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Presets of yours that are damaged and were left out: %1.</source>
        <translation>Eigene Voreinstellungen, die beschädigt sind und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Presets of yours that this version of Macula cannot read, and leaves as they are: %1.</source>
        <translation>Eigene Voreinstellungen, die diese Version von Macula nicht lesen kann und lässt, wie sie sind: %1.</translation>
    </message>
    <message>
        <source>The last change of your presets is not stored and lasts until this window closes: %1</source>
        <translation>Die letzte Änderung Ihrer Voreinstellungen ist nicht gespeichert und gilt, bis dieses Fenster schließt: %1</translation>
    </message>
    <message>
        <source>Nothing is kept between runs: presets of your own live until this window closes. Export those that you need.</source>
        <translation>Zwischen Starts wird nichts aufbewahrt: eigene Voreinstellungen gelten, bis dieses Fenster schließt. Exportieren Sie die, die Sie brauchen.</translation>
    </message>
    <message>
        <source>Keep preset</source>
        <translation>Voreinstellung behalten</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Voreinstellung umbenennen</translation>
    </message>
    <message>
        <source>Presets of the file that could not be kept: %1. %2</source>
        <translation>Voreinstellungen der Datei, die nicht behalten werden konnten: %1. %2</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetListModel</name>
    <message>
        <source>Favourites</source>
        <translation>Favoriten</translation>
    </message>
    <message>
        <source>Last used for such images</source>
        <translation>Zuletzt für solche Bilder verwendet</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>For such images</source>
        <translation>Für solche Bilder</translation>
    </message>
    <message>
        <source>For other images</source>
        <translation>Für andere Bilder</translation>
    </message>
    <message>
        <source>all that was seen</source>
        <translation>alles Gezeigte</translation>
    </message>
    <message>
        <source>%1, all that was seen</source>
        <translation>%1, alles Gezeigte</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Enter or a click folds this group</source>
        <translation>Eingabe oder ein Klick klappt diese Gruppe zu</translation>
    </message>
    <message>
        <source>Enter or a click shows this group</source>
        <translation>Eingabe oder ein Klick zeigt diese Gruppe</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>built in, is never changed</source>
        <translation>eingebaut, ändert sich nie</translation>
    </message>
    <message>
        <source>favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>shown now</source>
        <translation>jetzt gezeigt</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n presets, shown</source>
        <translation>
            <numerusform>%1, %n Voreinstellung, gezeigt</numerusform>
            <numerusform>%1, %n Voreinstellungen, gezeigt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n presets, folded</source>
        <translation>
            <numerusform>%1, %n Voreinstellung, zugeklappt</numerusform>
            <numerusform>%1, %n Voreinstellungen, zugeklappt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetNameDialog</name>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Voreinstellung</translation>
    </message>
    <message>
        <source>For all studies, so without anything of a patient</source>
        <translation>Für alle Studien, also ohne etwas von einem Patienten</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetNaming</name>
    <message>
        <source>Another name for “%1”.</source>
        <translation>Ein anderer Name für „%1“.</translation>
    </message>
    <message>
        <source>Rename the preset</source>
        <translation>Voreinstellung umbenennen</translation>
    </message>
    <message>
        <source>A preset of your own, like “%1”.</source>
        <translation>Eine eigene Voreinstellung, wie „%1“.</translation>
    </message>
    <message>
        <source>Save as copy</source>
        <translation>Als Kopie speichern</translation>
    </message>
    <message>
        <source>%1, as seen</source>
        <translation>%1, wie gezeigt</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, as a preset of your own. It is for all studies: clip and camera go with the size of the volume.</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, als eigene Voreinstellung. Sie gilt für alle Studien: Beschnitt und Kamera richten sich nach der Größe des Volumens.</translation>
    </message>
    <message>
        <source>Keep all that is seen</source>
        <translation>Alles Gezeigte behalten</translation>
    </message>
    <message>
        <source>The transfer function that is shown, as a preset of your own.</source>
        <translation>Die gezeigte Übertragungsfunktion, als eigene Voreinstellung.</translation>
    </message>
    <message>
        <source>Keep the curve</source>
        <translation>Kurve behalten</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetsController</name>
    <message>
        <source>Kept as presets of your own: %1.</source>
        <translation>Als eigene Voreinstellungen behalten: %1.</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Voreinstellung</translation>
    </message>
    <message>
        <source>Save P&amp;reset…</source>
        <translation>&amp;Voreinstellung speichern…</translation>
    </message>
    <message>
        <source>The transfer function, for other studies and programs</source>
        <translation>Die Übertragungsfunktion, für andere Studien und Programme</translation>
    </message>
    <message>
        <source> Preset </source>
        <translation> Voreinstellung </translation>
    </message>
    <message>
        <source>In this look a preset that is chosen gives the window only</source>
        <translation>In dieser Darstellung gibt eine gewählte Voreinstellung nur die Fensterung vor</translation>
    </message>
    <message>
        <source>What is seen, and in which colours</source>
        <translation>Was zu sehen ist und in welchen Farben</translation>
    </message>
    <message>
        <source>For &amp;Other Images</source>
        <translation>Für &amp;andere Bilder</translation>
    </message>
    <message>
        <source>Keep the &amp;Curve…</source>
        <translation>&amp;Kurve behalten…</translation>
    </message>
    <message>
        <source>The transfer function that is shown, as a preset of your own</source>
        <translation>Die gezeigte Übertragungsfunktion, als eigene Voreinstellung</translation>
    </message>
    <message>
        <source>Keep All That Is &amp;Seen…</source>
        <translation>Alles &amp;Gezeigte behalten…</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, as a preset of your own</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, als eigene Voreinstellung</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX</source>
        <translation>Von Macula, 3D Slicer, ParaView, VolView, MITK, Horos oder OsiriX</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Import presets</source>
        <translation>Voreinstellungen importieren</translation>
    </message>
    <message>
        <source>Presets (*.json *.vp *.xml *.mrml *.plist);;All files (*)</source>
        <translation>Voreinstellungen (*.json *.vp *.xml *.mrml *.plist);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Voreinstellung exportieren</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Voreinstellungen (*.json)</translation>
    </message>
    <message>
        <source>The preset is written to %1. Open it with --preset %1.</source>
        <translation>Die Voreinstellung ist in %1 gespeichert. Öffnen Sie sie mit --preset %1.</translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation>Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>Save the preset</source>
        <translation>Voreinstellung speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::QualityControl</name>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>%L1 ms</source>
        <translation>%L1 ms</translation>
    </message>
    <message>
        <source>Quality of frames in motion</source>
        <translation>Qualität der Bilder in Bewegung</translation>
    </message>
    <message>
        <source>Quality of frames in motion, from fast to accurate</source>
        <translation>Qualität der Bilder in Bewegung, von schnell bis genau</translation>
    </message>
    <message>
        <source>How much of a frame is traced while a hand moves. At rest the picture always becomes final.</source>
        <translation>Wie viel eines Bildes während der Bewegung verfolgt wird. In Ruhe wird das Bild immer endgültig.</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>As much as there is time for, without a choice</source>
        <translation>So viel, wie die Zeit erlaubt, ohne Auswahl</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Accurate</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Quality %1/%2</source>
        <translation>Qualität %1/%2</translation>
    </message>
    <message>
        <source>Quality of frames in motion. %1</source>
        <translation>Qualität der Bilder in Bewegung. %1</translation>
    </message>
    <message>
        <source>About %1 a frame on this machine.</source>
        <translation>Etwa %1 je Bild auf diesem Rechner.</translation>
    </message>
    <message>
        <source>How long a frame takes here is being measured.</source>
        <translation>Wie lange ein Bild hier braucht, wird gemessen.</translation>
    </message>
    <message>
        <source>Expected error (FLIP, 0 is none): %L1 where you look, %L2 in all.</source>
        <translation>Erwarteter Fehler (FLIP, 0 ist keiner): %L1, wo der Blick ist, %L2 im Ganzen.</translation>
    </message>
    <message>
        <source>It was measured with %1 bounces of light; the picture has %2 at every stop.</source>
        <translation>Gemessen wurde mit %1 Streuungen des Lichts; das Bild hat auf jeder Stufe %2.</translation>
    </message>
    <message>
        <source>Quality: automatic</source>
        <translation>Qualität: automatisch</translation>
    </message>
    <message>
        <source>Automatic: as much as there is time for. Move the slider to choose.</source>
        <translation>Automatisch: so viel, wie die Zeit erlaubt. Zum Wählen den Regler bewegen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::QualityController</name>
    <message>
        <source>Converging</source>
        <translation>Wird fertig gezeichnet</translation>
    </message>
    <message>
        <source>Frames in Motion: Faster</source>
        <translation>Bilder in Bewegung: schneller</translation>
    </message>
    <message>
        <source>Less is traced while a hand moves</source>
        <translation>Während der Bewegung wird weniger verfolgt</translation>
    </message>
    <message>
        <source>Frames in Motion: More Accurate</source>
        <translation>Bilder in Bewegung: genauer</translation>
    </message>
    <message>
        <source>More is traced while a hand moves</source>
        <translation>Während der Bewegung wird mehr verfolgt</translation>
    </message>
    <message>
        <source>Converge &amp;Now</source>
        <translation>&amp;Jetzt fertig zeichnen</translation>
    </message>
    <message>
        <source>Trace the picture at rest until it is final, with half of the usual noise</source>
        <translation>Das ruhende Bild verfolgen, bis es endgültig ist, mit der Hälfte des üblichen Rauschens</translation>
    </message>
    <message>
        <source>Stop Converging</source>
        <translation>Fertigzeichnen anhalten</translation>
    </message>
    <message>
        <source>There is no picture to converge yet.</source>
        <translation>Es gibt noch kein Bild fertig zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::RecentMenu</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>What was opened since the program was started; it is not kept for longer</source>
        <translation>Was seit dem Start des Programms geöffnet wurde; länger wird es nicht aufbewahrt</translation>
    </message>
    <message>
        <source>&amp;Forget All</source>
        <translation>Alle &amp;vergessen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeBar</name>
    <message>
        <source>Study alone</source>
        <translation>Studie allein</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Second alone</source>
        <translation>Zweites allein</translation>
    </message>
    <message>
        <source>In colours over the study</source>
        <translation>Farbig über der Studie</translation>
    </message>
    <message>
        <source>Hot iron</source>
        <translation>Glühendes Eisen</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Second Volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>The second volume</source>
        <translation>Das zweite Volumen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the second volume; the study stays</source>
        <translation>Das zweite Volumen schließen; die Studie bleibt</translation>
    </message>
    <message>
        <source>How the second volume is shown</source>
        <translation>Wie das zweite Volumen gezeigt wird</translation>
    </message>
    <message>
        <source>The second volume beside the study, in its place, or over it. J puts it in the place of the study, and back</source>
        <translation>Das zweite Volumen neben der Studie, an ihrer Stelle oder darüber. J setzt es an die Stelle der Studie und zurück</translation>
    </message>
    <message>
        <source>How the second volume is linked</source>
        <translation>Wie das zweite Volumen gekoppelt ist</translation>
    </message>
    <message>
        <source>What takes a place in the study to the same place in the second volume. By hand, the wheel over the second volume moves it alone</source>
        <translation>Was einen Ort der Studie an denselben Ort im zweiten Volumen führt. Von Hand bewegt das Rad über dem zweiten Volumen nur dieses</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Same frame of reference</source>
        <translation>Gleiches Koordinatensystem</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Registriert</translation>
    </message>
    <message>
        <source>Colours of the second volume</source>
        <translation>Farben des zweiten Volumens</translation>
    </message>
    <message>
        <source>Colours of the second volume where it lies over the study</source>
        <translation>Farben des zweiten Volumens, wo es über der Studie liegt</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Opacity of the second volume in percent</source>
        <translation>Deckkraft des zweiten Volumens in Prozent</translation>
    </message>
    <message>
        <source>Opacity of the second volume over the study: %1 %</source>
        <translation>Deckkraft des zweiten Volumens über der Studie: %1 %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Window of the second volume from</source>
        <translation>Fensterung des zweiten Volumens von</translation>
    </message>
    <message>
        <source>Window of the second volume up to</source>
        <translation>Fensterung des zweiten Volumens bis</translation>
    </message>
    <message>
        <source>Window of the second volume</source>
        <translation>Fensterung des zweiten Volumens</translation>
    </message>
    <message>
        <source>What is black and what is white of the second volume, in its own unit</source>
        <translation>Was am zweiten Volumen schwarz und was weiß ist, in seiner eigenen Einheit</translation>
    </message>
    <message>
        <source>Registering…</source>
        <translation>Wird registriert…</translation>
    </message>
    <message>
        <source>In 3D too</source>
        <translation>Auch in 3D</translation>
    </message>
    <message>
        <source>The second volume in the 3D picture</source>
        <translation>Das zweite Volumen im 3D-Bild</translation>
    </message>
    <message>
        <source>The second volume in one 3D picture with the study. It has to be of the same patient, and linked by more than hand; projections show the study alone</source>
        <translation>Das zweite Volumen in einem 3D-Bild mit der Studie. Es muss vom selben Patienten und anders als von Hand verknüpft sein; Projektionen zeigen die Studie allein</translation>
    </message>
    <message>
        <source>Second volume in 3D</source>
        <translation>Zweites Volumen in 3D</translation>
    </message>
    <message>
        <source>Preset of the second volume in 3D</source>
        <translation>Voreinstellung des zweiten Volumens in 3D</translation>
    </message>
    <message>
        <source>What the second volume is drawn with in 3D: window, colours and opacity from here, or a preset</source>
        <translation>Womit das zweite Volumen in 3D gezeichnet wird: Fensterung, Farben und Deckkraft von hier, oder eine Voreinstellung</translation>
    </message>
    <message>
        <source>Preset of the second volume</source>
        <translation>Voreinstellung des zweiten Volumens</translation>
    </message>
    <message>
        <source>As over slices</source>
        <translation>Wie über Schichten</translation>
    </message>
    <message>
        <source>One window</source>
        <translation>Ein Fenster</translation>
    </message>
    <message>
        <source>One window for the study and the second volume</source>
        <translation>Ein Fenster für die Untersuchung und das zweite Volumen</translation>
    </message>
    <message>
        <source>Slices of both through one window, as phases are compared. Both have to have one unit</source>
        <translation>Schichten von beiden durch ein Fenster, wie Phasen verglichen werden. Beide müssen eine Einheit haben</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeController</name>
    <message>
        <source>The second volume that was beside this study is not open; open it with Ctrl+B to see both as they were.</source>
        <translation>Das zweite Volumen, das neben dieser Studie stand, ist nicht geöffnet; Strg+B öffnet es und zeigt beide, wie sie waren.</translation>
    </message>
    <message>
        <source>Where the second volume lay when this study was left is not taken over: the images had other values or positions then, or an older Macula kept it. It is placed anew.</source>
        <translation>Wo das zweite Volumen lag, als diese Studie verlassen wurde, wird nicht übernommen: Die Bilder hatten damals andere Werte oder Positionen, oder ein älteres Macula hat es aufgehoben. Es wird neu eingepasst.</translation>
    </message>
    <message>
        <source>Second volume: %1</source>
        <translation>Zweites Volumen: %1</translation>
    </message>
    <message>
        <source>The second volume shows another part of the body: nothing of it lies in the study.</source>
        <translation>Das zweite Volumen zeigt einen anderen Teil des Körpers: nichts davon liegt in der Studie.</translation>
    </message>
    <message>
        <source>Open &amp;Beside…</source>
        <translation>Da&amp;neben öffnen…</translation>
    </message>
    <message>
        <source>A prior, a PET or an MR beside this study: what is selected in the list of studies, else of a folder</source>
        <translation>Eine Voraufnahme, ein PET oder ein MR neben dieser Studie: was in der Liste der Studien gewählt ist, sonst aus einem Ordner</translation>
    </message>
    <message>
        <source>Open File Besi&amp;de…</source>
        <translation>Datei daneben ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>The series of an image, or a NIfTI, NRRD or MetaImage file, beside this study</source>
        <translation>Die Serie eines Bildes oder eine NIfTI-, NRRD- oder MetaImage-Datei neben dieser Studie</translation>
    </message>
    <message>
        <source>&amp;Close Second Volume</source>
        <translation>Zweites Volumen s&amp;chließen</translation>
    </message>
    <message>
        <source>The study stays open</source>
        <translation>Die Studie bleibt offen</translation>
    </message>
    <message>
        <source>Second Volume in the Place of the Study</source>
        <translation>Zweites Volumen an Stelle der Studie</translation>
    </message>
    <message>
        <source>The same planes of the second volume, and back</source>
        <translation>Dieselben Ebenen des zweiten Volumens, und zurück</translation>
    </message>
    <message>
        <source>Open a second volume beside the study</source>
        <translation>Zweites Volumen neben der Studie öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeLoader</name>
    <message>
        <source>Registering the second volume</source>
        <translation>Das zweite Volumen wird registriert</translation>
    </message>
    <message>
        <source>Opening the second volume</source>
        <translation>Das zweite Volumen wird geöffnet</translation>
    </message>
    <message>
        <source>There is no study that a second volume could be beside.</source>
        <translation>Es gibt keine Studie, neben der ein zweites Volumen stehen könnte.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Second volume closed</source>
        <translation>Zweites Volumen geschlossen</translation>
    </message>
    <message>
        <source>This is the volume that is open already.</source>
        <translation>Das ist das Volumen, das schon offen ist.</translation>
    </message>
    <message>
        <source>Choose another series to stand beside it.</source>
        <translation>Wählen Sie eine andere Serie, die daneben steht.</translation>
    </message>
    <message>
        <source>Second volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Same frame of reference</source>
        <translation>Gleiches Koordinatensystem</translation>
    </message>
    <message>
        <source>Linked by hand</source>
        <translation>Von Hand gekoppelt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationKeeper</name>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>A segmentation that was shown with this study is not in the folder; nothing of it is shown or hidden.</source>
        <translation>Eine Segmentierung, die mit dieser Studie gezeigt wurde, ist nicht im Ordner; nichts davon wird gezeigt oder ausgeblendet.</translation>
    </message>
    <message numerus="yes">
        <source>There are %n segmentations of this volume: F11.</source>
        <translation>
            <numerusform>Es gibt eine Segmentierung dieses Volumens: F11.</numerusform>
            <numerusform>Es gibt %n Segmentierungen dieses Volumens: F11.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationPanel</name>
    <message>
        <source>Drawn by hand</source>
        <translation>Von Hand gezeichnet</translation>
    </message>
    <message>
        <source>Made by a person with a program</source>
        <translation>Von einem Menschen mit einem Programm erstellt</translation>
    </message>
    <message>
        <source>Made by a program</source>
        <translation>Von einem Programm erstellt</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>alone</source>
        <translation>allein</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>Segmentations of the folder; a check mark shows them on slices</source>
        <translation>Segmentierungen des Ordners; ein Häkchen zeigt sie auf Schichten</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of the segment on slices, and in 3D where it is in colour there</source>
        <translation>Farbe des Segments auf Schichten, und in 3D, wo es dort farbig ist</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Cross-hair to the middle of the segment</source>
        <translation>Fadenkreuz in die Mitte des Segments</translation>
    </message>
    <message>
        <source>Alone</source>
        <translation>Allein</translation>
    </message>
    <message>
        <source>In 3D, this segment and others that are alone, and nothing else</source>
        <translation>In 3D dieses Segment und andere, die allein sind, und sonst nichts</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>In 3D, all but this segment</source>
        <translation>In 3D alles außer diesem Segment</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How opaque the segment is filled on slices, in %</source>
        <translation>Wie deckend das Segment auf Schichten gefüllt ist, in %</translation>
    </message>
    <message>
        <source>In 3D</source>
        <translation>In 3D</translation>
    </message>
    <message>
        <source>Segmentation %1</source>
        <translation>Segmentierung %1</translation>
    </message>
    <message>
        <source>Volume in ml, once the segmentation is shown</source>
        <translation>Volumen in ml, sobald die Segmentierung gezeigt wird</translation>
    </message>
    <message>
        <source>Volume in ml: its voxels, times that of one</source>
        <translation>Volumen in ml: seine Voxel mal das eines Voxels</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Looking for segmentations.</source>
        <translation>Segmentierungen werden gesucht.</translation>
    </message>
    <message>
        <source>There are no segmentations in this folder.</source>
        <translation>In diesem Ordner sind keine Segmentierungen.</translation>
    </message>
    <message>
        <source>This segment has no voxel in the volume.</source>
        <translation>Dieses Segment hat im Volumen kein Voxel.</translation>
    </message>
    <message>
        <source>Colour of the segment</source>
        <translation>Farbe des Segments</translation>
    </message>
    <message>
        <source>in colour</source>
        <translation>farbig</translation>
    </message>
    <message>
        <source>In colour</source>
        <translation>Farbig</translation>
    </message>
    <message>
        <source>In 3D, the matter in this segment has the colour of the segment</source>
        <translation>In 3D hat das Gewebe in diesem Segment die Farbe des Segments</translation>
    </message>
    <message>
        <source>In 3D, how much of the matter in a segment in colour is left, in %</source>
        <translation>In 3D, wie viel vom Gewebe eines farbigen Segments bleibt, in %</translation>
    </message>
    <message>
        <source>Opacity in 3D</source>
        <translation>Deckkraft in 3D</translation>
    </message>
    <message>
        <source>Volumes are estimates: the size of a pixel is not calibrated.</source>
        <translation>Volumina sind Schätzungen: Die Pixelgröße ist nicht kalibriert.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationsController</name>
    <message>
        <source>Loading a segmentation</source>
        <translation>Eine Segmentierung wird geladen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsController</name>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Language, look, keys, and what is kept</source>
        <translation>Sprache, Aussehen, Tasten und was aufbewahrt wird</translation>
    </message>
    <message>
        <source>The settings are saved. Language and sessions follow them from the next start.</source>
        <translation>Die Einstellungen sind gespeichert. Sprache und Sitzungen folgen ihnen ab dem nächsten Start.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsDialog</name>
    <message>
        <source>&amp;High contrast: black, white and yellow</source>
        <translation>&amp;Hoher Kontrast: Schwarz, Weiß und Gelb</translation>
    </message>
    <message>
        <source>&amp;Patient and study over pictures</source>
        <translation>&amp;Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>DICOM pictures &amp;without patient and study</source>
        <translation>DICOM-Bilder &amp;ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of settings</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>Left and Right go from page to page</source>
        <translation>Links und Rechts gehen von Seite zu Seite</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Take all pages as they are</source>
        <translation>Alle Seiten so übernehmen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>What was chosen on the command line counts more, until the program ends.</source>
        <translation>Was auf der Befehlszeile gewählt wurde, gilt mehr, bis das Programm endet.</translation>
    </message>
    <message>
        <source>These settings are not kept: the program was started so.</source>
        <translation>Diese Einstellungen werden nicht aufbewahrt: das Programm wurde so gestartet.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window, and how numbers are written; from the next start on</source>
        <translation>Des Fensters, und wie Zahlen geschrieben werden; ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Instead of the dark window; at once</source>
        <translation>Statt des dunklen Fensters; sofort</translation>
    </message>
    <message>
        <source>Size of letters, times that of the desktop</source>
        <translation>Schriftgröße, mal die des Desktops</translation>
    </message>
    <message>
        <source>Times the size of the desktop&apos;s letters, 0.8 to 2; at once</source>
        <translation>Mal die Schriftgröße des Desktops, 0,8 bis 2; sofort</translation>
    </message>
    <message>
        <source>Patient and study over pictures</source>
        <translation>Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>When the window opens; N hides and shows them at any time</source>
        <translation>Wenn das Fenster sich öffnet; N blendet sie jederzeit aus und ein</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Quality of saved pictures</source>
        <translation>Qualität gespeicherter Bilder</translation>
    </message>
    <message>
        <source>What Save Picture begins with: more samples per pixel take more time</source>
        <translation>Womit Bild speichern beginnt: mehr Abtastungen je Pixel brauchen mehr Zeit</translation>
    </message>
    <message>
        <source>DICOM pictures without patient and study</source>
        <translation>DICOM-Bilder ohne Patient und Studie</translation>
    </message>
    <message>
        <source>What Save Picture begins with: nothing of the patient is written, and all UIDs are new</source>
        <translation>Womit Bild speichern beginnt: vom Patienten wird nichts geschrieben, und alle UIDs sind neu</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Folder of stored sessions</source>
        <translation>Ordner der gespeicherten Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of stored sessions</source>
        <translation>Den Ordner der gespeicherten Sitzungen wählen</translation>
    </message>
    <message>
        <source>Choose a folder; it must be empty, or one that Macula made</source>
        <translation>Einen Ordner wählen; er muss leer sein oder von Macula stammen</translation>
    </message>
    <message>
        <source>Days that studies are kept</source>
        <translation>Tage, die Studien aufbewahrt werden</translation>
    </message>
    <message>
        <source>What was not opened for so many days is deleted at the start, 1 to %1 days; nothing is deleted with 0</source>
        <translation>Was so viele Tage nicht geöffnet wurde, wird beim Start gelöscht, 1 bis %1 Tage; mit 0 wird nichts gelöscht</translation>
    </message>
    <message>
        <source>for ever</source>
        <translation>für immer</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Aufbewahren</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples</source>
        <translation>
            <numerusform>%1: %n Abtastung</numerusform>
            <numerusform>%1: %n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Where previews, and how studies were left, are kept; empty: the usual folder. From the next start on; what is in the old folder stays there.</source>
        <translation>Wo Vorschauen und der letzte Stand von Studien aufbewahrt werden; leer: der übliche Ordner. Ab dem nächsten Start; was im alten Ordner ist, bleibt dort.</translation>
    </message>
    <message>
        <source>Room for stored previews in MB</source>
        <translation>Platz für gespeicherte Vorschauen in MB</translation>
    </message>
    <message>
        <source>Of all stored previews together, in MB; above it those that were not used for longest go. From the next start on.</source>
        <translation>Aller gespeicherten Vorschauen zusammen, in MB; darüber gehen die, die am längsten nicht gebraucht wurden. Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Previews</source>
        <translation>&amp;Vorschauen</translation>
    </message>
    <message>
        <source>Names and IDs are not kept, but previews and views tell as much of a patient as pictures do.</source>
        <translation>Namen und IDs werden nicht aufbewahrt, aber Vorschauen und Ansichten verraten so viel von einem Patienten wie Bilder.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ShownAdditions</name>
    <message>
        <source>There is not enough memory for the second volume in 3D.</source>
        <translation>Für das zweite Volumen in 3D ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Close other programs, or look at it on slices.</source>
        <translation>Schließen Sie andere Programme, oder sehen Sie es auf Schichten an.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ShownVolume</name>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Open view</source>
        <translation>Ansicht öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceCine</name>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SlicePopups</name>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceTravel</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Second volume moved</source>
        <translation>Zweites Volumen verschoben</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceView</name>
    <message>
        <source>%1 slices</source>
        <translation>%1e Schichten</translation>
    </message>
    <message>
        <source>%1 slices of the second volume</source>
        <translation>%1e Schichten des zweiten Volumens</translation>
    </message>
    <message>
        <source>%1 slices, in mm. Wheel: next slice; right drag: window; right click: windows</source>
        <translation>%1e Schichten, in mm. Rad: nächste Schicht; rechts ziehen: Fensterung; Rechtsklick: Fensterungen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StateController</name>
    <message>
        <source>How this study was left cannot be read; it is shown as when opened first.</source>
        <translation>Wie diese Studie verlassen wurde, kann nicht gelesen werden; sie wird wie beim ersten Öffnen gezeigt.</translation>
    </message>
    <message>
        <source>The preset %1 is not made for this kind of volume; %2 is used instead.</source>
        <translation>Die Voreinstellung %1 ist nicht für solche Volumen gemacht; stattdessen wird %2 verwendet.</translation>
    </message>
    <message>
        <source>This study is shown as it was left. The View menu shows it as when first opened.</source>
        <translation>Diese Studie wird gezeigt, wie sie verlassen wurde. Das Menü Ansicht zeigt sie wie beim ersten Öffnen.</translation>
    </message>
    <message>
        <source>Show as when first opened</source>
        <translation>Wie beim ersten Öffnen zeigen</translation>
    </message>
    <message>
        <source>Preset, lights, clip, look and camera that a study has which nobody has seen yet</source>
        <translation>Voreinstellung, Beleuchtung, Beschnitt, Darstellung und Kamera einer Studie, die noch niemand gesehen hat</translation>
    </message>
    <message>
        <source>Show afresh</source>
        <translation>Neu zeigen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StatusController</name>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>How true the picture is</source>
        <translation>Wie getreu das Bild ist</translation>
    </message>
    <message>
        <source>Voxels and their size</source>
        <translation>Voxel und ihre Größe</translation>
    </message>
    <message>
        <source>The preview with all pixels that is shown while a hand moves; it gets sharper while nothing moves</source>
        <translation>Die Vorschau mit allen Pixeln, die während der Bewegung gezeigt wird; sie wird schärfer, solange sich nichts bewegt</translation>
    </message>
    <message>
        <source>Pixels, pictures per second</source>
        <translation>Pixel, Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>The picture in 3D is being made…</source>
        <translation>Das Bild in 3D entsteht…</translation>
    </message>
    <message>
        <source>Starting the graphics device again…</source>
        <translation>Das Grafikgerät wird neu gestartet…</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and is started again; the picture is made anew. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wird neu gestartet; das Bild wird neu erstellt. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and was started again. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wurde neu gestartet. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message numerus="yes">
        <source>, %n samples left out</source>
        <translation>
            <numerusform>, %n Abtastung ausgelassen</numerusform>
            <numerusform>, %n Abtastungen ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>, less than the full resolution</source>
        <translation>, weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>, %1/s</source>
        <translation>, %1/s</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SteepChoice</name>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Steil</translation>
    </message>
    <message>
        <source>Which curves are edited</source>
        <translation>Welche Kurven bearbeitet werden</translation>
    </message>
    <message>
        <source>Curves of matter whose values change little around a place, or steeply</source>
        <translation>Kurven der Materie, deren Werte sich um einen Ort wenig oder steil ändern</translation>
    </message>
    <message>
        <source>Remove steep</source>
        <translation>Steile entfernen</translation>
    </message>
    <message>
        <source>Add steep</source>
        <translation>Steile hinzufügen</translation>
    </message>
    <message>
        <source>Remove the curves of steep matter</source>
        <translation>Die Kurven steiler Materie entfernen</translation>
    </message>
    <message>
        <source>Add curves for steep matter</source>
        <translation>Kurven für steile Materie hinzufügen</translation>
    </message>
    <message>
        <source>All matter has the curves of flat matter again; can be undone</source>
        <translation>Alle Materie hat wieder die Kurven der flachen; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Where values change steeply, matter gets curves of its own</source>
        <translation>Wo Werte sich steil ändern, erhält die Materie eigene Kurven</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyBrowser</name>
    <message>
        <source>Search the studies of the folder</source>
        <translation>Die Studien des Ordners durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Name, ID, date, modality or description; all words have to be there. Down or Enter goes to the list, Esc ends the search.</source>
        <translation>Name, ID, Datum, Modalität oder Beschreibung; alle Wörter müssen vorkommen. Ab oder Eingabe geht zur Liste, Esc beendet die Suche.</translation>
    </message>
    <message>
        <source>Studies, series and volumes of the folder</source>
        <translation>Studien, Serien und Volumen des Ordners</translation>
    </message>
    <message>
        <source>No folder of images is open.</source>
        <translation>Kein Ordner mit Bildern ist offen.</translation>
    </message>
    <message>
        <source>There are no studies in this folder.</source>
        <translation>In diesem Ordner sind keine Studien.</translation>
    </message>
    <message>
        <source>Nothing matches “%1”.</source>
        <translation>Nichts passt zu „%1“.</translation>
    </message>
    <message>
        <source>The folder is still being read. What is in it can be opened then.</source>
        <translation>Der Ordner wird noch gelesen. Was darin ist, kann danach geöffnet werden.</translation>
    </message>
    <message>
        <source>Open &amp;Beside</source>
        <translation>Da&amp;neben öffnen</translation>
    </message>
    <message>
        <source>Show this volume beside the study that is open</source>
        <translation>Dieses Volumen neben der offenen Studie zeigen</translation>
    </message>
    <message>
        <source>What is in the folder; sizes of voxels are in mm. One click selects; a double click or Enter opens, be it a volume or a view of one that was kept. The files are only read, and stay where they are.</source>
        <translation>Was im Ordner ist; Voxelgrößen sind in mm. Ein Klick wählt aus; ein Doppelklick oder Eingabe öffnet, sei es ein Volumen oder eine Ansicht davon, die aufgehoben wurde. Die Dateien werden nur gelesen und bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>Nothing of this folder is open.</source>
        <translation>Aus diesem Ordner ist nichts geöffnet.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyTreeModel</name>
    <message>
        <source>Open now</source>
        <translation>Jetzt offen</translation>
    </message>
    <message>
        <source>Seen before; opens as it was left</source>
        <translation>Schon gesehen; öffnet sich, wie sie verlassen wurde</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Das kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>A double click or Enter opens it.</source>
        <translation>Ein Doppelklick oder Eingabe öffnet es.</translation>
    </message>
    <message>
        <source>Cannot be opened: %1</source>
        <translation>Kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>A double click or Enter opens its series, and shows it so.</source>
        <translation>Ein Doppelklick oder die Eingabetaste öffnet die Serie dazu und zeigt sie so.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TableController</name>
    <message>
        <source>Looking for the table</source>
        <translation>Der Tisch wird gesucht</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TableRemoval</name>
    <message>
        <source>&amp;Remove Table</source>
        <translation>&amp;Tisch entfernen</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden</translation>
    </message>
    <message>
        <source>Leave out the table and what else lies beside the patient</source>
        <translation>Den Tisch und was sonst neben dem Patienten liegt weglassen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ToolBox</name>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Four Panes</source>
        <translation>Vier Bildfelder</translation>
    </message>
    <message>
        <source>3D Only</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>Axial Only</source>
        <translation>Nur axial</translation>
    </message>
    <message>
        <source>Coronal Only</source>
        <translation>Nur koronar</translation>
    </message>
    <message>
        <source>Sagittal Only</source>
        <translation>Nur sagittal</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Slab thickness in mm</source>
        <translation>Dicke des Slabs in mm</translation>
    </message>
    <message>
        <source>Thickness of the slab, 0 to %1 mm; 0 is the plane alone</source>
        <translation>Dicke des Slabs, 0 bis %1 mm; 0 ist die Ebene allein</translation>
    </message>
    <message>
        <source>Slab Thickness</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>Slab Kind</source>
        <translation>Art des Slabs</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>White and black change places on slices; values stay as they are</source>
        <translation>Weiß und Schwarz tauschen auf Schichten den Platz; Werte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Acquired Planes</source>
        <translation>Aufnahmeebenen</translation>
    </message>
    <message>
        <source>Slices in the planes of the acquisition, or in those of the patient</source>
        <translation>Schichten in den Ebenen der Aufnahme oder in denen des Patienten</translation>
    </message>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
    <message>
        <source>Run through the slices, or stop</source>
        <translation>Die Schichten durchlaufen oder anhalten</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Slab kind: %1</source>
        <translation>Art des Slabs: %1</translation>
    </message>
    <message>
        <source>What is shown of the values across the slab: %1</source>
        <translation>Was von den Werten durch den Slab gezeigt wird: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferCurve</name>
    <message>
        <source>Transfer function: opacity and colour over value</source>
        <translation>Übertragungsfunktion: Deckkraft und Farbe über dem Wert</translation>
    </message>
    <message>
        <source>Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how often each value is in the volume behind it; colours below.
Drag a point; double click adds one, Delete removes it; arrows move it, with Shift finer.
Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with Ctrl: more opaque upwards.
Wheel: zoom the axis; drag the axis to move it; double click on it shows all.</source>
        <translation>Werte%1 von links nach rechts, Deckkraft (0 bis 1, einer %2 mm dicken Lage) nach oben, dahinter, wie oft jeder Wert im Volumen ist; darunter Farben.
Einen Punkt ziehen; Doppelklick fügt einen hinzu, Entf entfernt ihn; Pfeile verschieben ihn, mit Umschalt feiner.
Rechts ziehen oder Alt + links ziehen neben den Punkten: alle verschieben, nach oben verbreitern; mit Strg: nach oben deckender.
Rad: die Achse zoomen; die Achse ziehen verschiebt sie; Doppelklick darauf zeigt alles.</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>Colour point %1 of %2 at %3</source>
        <translation>Farbpunkt %1 von %2 bei %3</translation>
    </message>
    <message>
        <source>Opacity point %1 of %2 at %3, opacity %4</source>
        <translation>Deckkraftpunkt %1 von %2 bei %3, Deckkraft %4</translation>
    </message>
    <message numerus="yes">
        <source>%n points; none is selected. Arrows shift and widen all of them, Tab goes through them.</source>
        <translation>
            <numerusform>%n Punkt; keiner ist ausgewählt. Pfeile verschieben und weiten alle, Tab geht durch sie.</numerusform>
            <numerusform>%n Punkte; keiner ist ausgewählt. Pfeile verschieben und weiten alle, Tab geht durch sie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferDrag</name>
    <message>
        <source>Transfer function: shifted by %1%2, %3 times as wide</source>
        <translation>Übertragungsfunktion: um %1%2 verschoben, %3-mal so breit</translation>
    </message>
    <message>
        <source>The transfer function cannot be moved yet: how it lies on these values is still counted.</source>
        <translation>Die Übertragungsfunktion kann noch nicht verschoben werden: wie sie auf diesen Werten liegt, wird noch gezählt.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferFunctionEditor</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern als…</translation>
    </message>
    <message>
        <source>Which preset is edited</source>
        <translation>Welche Voreinstellung bearbeitet wird</translation>
    </message>
    <message>
        <source>Reset the transfer function</source>
        <translation>Die Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the preset as it was chosen; can be undone</source>
        <translation>Zurück zur Voreinstellung, wie sie gewählt wurde; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Save the transfer function as a preset</source>
        <translation>Die Übertragungsfunktion als Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Keep this transfer function as a preset of your own</source>
        <translation>Diese Übertragungsfunktion als eigene Voreinstellung behalten</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Reset transfer function</source>
        <translation>Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Open a study to edit its transfer function.</source>
        <translation>Öffnen Sie eine Studie, um ihre Übertragungsfunktion zu bearbeiten.</translation>
    </message>
    <message>
        <source>%1: your copy of %2.</source>
        <translation>%1: Ihre Kopie von %2.</translation>
    </message>
    <message>
        <source>%1, as it was chosen. The first change makes a copy.</source>
        <translation>%1, wie gewählt. Die erste Änderung legt eine Kopie an.</translation>
    </message>
    <message>
        <source>It is being fitted to the values of the volume.</source>
        <translation>Sie wird an die Werte des Volumens angepasst.</translation>
    </message>
    <message>
        <source>It is stretched to this volume; values are those of the volume.</source>
        <translation>Sie ist auf dieses Volumen gestreckt; Werte sind die des Volumens.</translation>
    </message>
    <message>
        <source>It is made for other units than those of the series.</source>
        <translation>Sie ist für andere Einheiten gemacht als die der Serie.</translation>
    </message>
    <message>
        <source>Its gradient opacity is kept.</source>
        <translation>Ihre Gradienten-Deckkraft bleibt erhalten.</translation>
    </message>
    <message>
        <source>These are its curves of steep matter.</source>
        <translation>Dies sind ihre Kurven steiler Materie.</translation>
    </message>
    <message>
        <source>These are its curves of flat matter.</source>
        <translation>Dies sind ihre Kurven flacher Materie.</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Materie</translation>
    </message>
    <message>
        <source>Show how matter scatters light</source>
        <translation>Zeigen, wie Materie Licht streut</translation>
    </message>
    <message>
        <source>How matter scatters light: its surface, and anisotropy</source>
        <translation>Wie Materie Licht streut: ihre Oberfläche und Anisotropie</translation>
    </message>
</context>
<context>
    <name>macula::viewer::UndoActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back: %1</source>
        <translation>Die letzte Änderung zurücknehmen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make it again: %1</source>
        <translation>Noch einmal machen: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::View3dController</name>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Cube and scale</source>
        <translation>Würfel und Maßstab</translation>
    </message>
    <message>
        <source>From where the patient is seen, and how long a centimetre is: with parallel rays everywhere, else at the depth of what the camera turns around</source>
        <translation>Von wo der Patient gesehen wird und wie lang ein Zentimeter ist: bei parallelen Strahlen überall, sonst in der Tiefe dessen, um das sich die Kamera dreht</translation>
    </message>
    <message>
        <source>Parallel rays</source>
        <translation>Parallele Strahlen</translation>
    </message>
    <message>
        <source>The same millimetres for each pixel at every depth</source>
        <translation>In jeder Tiefe gleich viele Millimeter je Pixel</translation>
    </message>
    <message>
        <source>Trace where the pointer is, while moving</source>
        <translation>Bei Bewegung dort verfolgen, wo der Zeiger ist</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ViewerWidget</name>
    <message>
        <source>Cube and scale</source>
        <translation>Würfel und Maßstab</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ViewsController</name>
    <message>
        <source>Open &amp;View…</source>
        <translation>&amp;Ansicht öffnen…</translation>
    </message>
    <message>
        <source>Show this study as it was when a view was saved</source>
        <translation>Diese Studie so zeigen, wie sie beim Speichern einer Ansicht war</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>All that was chosen, and the camera, for another time</source>
        <translation>Alles, was gewählt wurde, und die Kamera, für ein andermal</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Ansicht öffnen</translation>
    </message>
    <message>
        <source>Views (*.json)</source>
        <translation>Ansichten (*.json)</translation>
    </message>
    <message>
        <source>There is no view to save yet.</source>
        <translation>Es gibt noch keine Ansicht zu speichern.</translation>
    </message>
    <message>
        <source>Save the view</source>
        <translation>Ansicht speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::VolumeChoice</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Which volume of the folder is open; choose another one here</source>
        <translation>Welches Volumen des Ordners offen ist; wählen Sie hier ein anderes</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>macula::viewer::WorkBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; what is shown now stays</source>
        <translation>Anhalten; was jetzt zu sehen ist, bleibt</translation>
    </message>
</context>
<context>
    <name>titles</name>
    <message>
        <source>Cinematic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray cast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Average (X-ray)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lung</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angiography</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SUV 0 to 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SUV 0 to 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SUV 0 to 15</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SUV 0 to 20</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual for PET</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anterior</source>
        <translation type="unfinished">anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation type="unfinished">posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished">links</translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished">rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation type="unfinished">superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation type="unfinished">inferior</translation>
    </message>
    <message>
        <source>Own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation type="unfinished">Presentation State</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anisotropy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steep gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the light that the steepest boundary scatters like a rough, wet surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steepness of a boundary that is half a surface, in values per mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of surfaces: highlights are smaller and brighter where it is less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of surfaces: the part that they reflect of light which falls straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of what scatters like a cloud: above 0 light goes on forwards, below 0 it comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of presets with curves for steep matter: where half of the matter is steep, in values per mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Daylight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theatre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished">Fensterung</translation>
    </message>
    <message>
        <source>Only the front half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a ball in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts, air black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut, air black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the lower half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the patient&apos;s left half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the back half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the patient&apos;s right half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only an axial slab through the middle, a tenth of the height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the upper half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic abdomen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic airways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic aorta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic bronchi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic chest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic colon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic coronary arteries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic teeth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic fat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic heart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic kidneys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic liver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic lung</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic micro-CT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic MR brain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic MR knee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic MR skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic MR vessels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic MR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic muscle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic PET</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic soft tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic tendons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cinematic vessels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
