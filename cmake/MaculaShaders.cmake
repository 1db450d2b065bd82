# GLSL to Vulkan 1.3 SPIR-V at build time, checked, and embedded as C++.
#
#   macula_shaders(trace SOURCES trace/path.comp trace/resolve.comp)
#
# makes the library macula::shaders_trace, whose header "shaders/trace.h" declares one
# `macula::gpu::ShaderCode macula::shaders::trace_path_comp` per source, named after its path below shaders/ (or, for
# sources elsewhere, below the folder that lists them). Includes are relative to shaders/; sources start with
# `#version 460` and `#extension GL_GOOGLE_include_directive : require`. Debug names stay in: reflection needs them.

# Script mode: embeds one module. -DSPIRV=in.spv -DCPP=out.cpp -DSYMBOL=trace_path_comp -DNAME=trace/path.comp
if(CMAKE_SCRIPT_MODE_FILE)
    file(READ ${SPIRV} hex HEX)
    string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${hex}")
    string(REGEX REPLACE "((0x........,){12})" "\\1\n    " words "${words}")
    file(WRITE ${CPP} "// Made from ${NAME}. Do not edit.
#include \"pipeline/gpu/shader_code.h\"

namespace macula::shaders {
namespace {
constexpr std::uint32_t kWords[] = {
    ${words}
};
}  // namespace
extern const gpu::ShaderCode ${SYMBOL};
constinit const gpu::ShaderCode ${SYMBOL}{\"${NAME}\", kWords};
}  // namespace macula::shaders
")
    return()
endif()

find_program(GLSLANG_VALIDATOR glslangValidator DOC "GLSL compiler: package glslang-tools")
find_program(SPIRV_VAL spirv-val DOC "SPIR-V validator: package spirv-tools")
foreach(tool GLSLANG_VALIDATOR SPIRV_VAL)
    if(NOT ${tool})
        message(FATAL_ERROR "${tool} not found: install glslang-tools and spirv-tools, or set ${tool}.")
    endif()
endforeach()
set(MACULA_SHADERS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(macula_shaders target)
    cmake_parse_arguments(S "" "" "SOURCES" ${ARGN})
    set(root ${PROJECT_SOURCE_DIR}/shaders)
    set(generated ${PROJECT_BINARY_DIR}/generated)
    set(work ${generated}/shaders/${target})
    file(MAKE_DIRECTORY ${work})

    set(declarations "")
    set(cpps "")
    foreach(source ${S_SOURCES})
        cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
        cmake_path(IS_PREFIX root ${path} inside)
        if(inside)
            cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${root} OUTPUT_VARIABLE name)
        else()
            cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE name)
        endif()
        string(MAKE_C_IDENTIFIER ${name} symbol)
        set(spirv ${work}/${symbol}.spv)
        set(cpp ${work}/${symbol}.cpp)
        add_custom_command(
            OUTPUT ${spirv}
            COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 -I${root} --depfile ${spirv}.d -o ${spirv} ${path}
            COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spirv}
            DEPENDS ${path} DEPFILE ${spirv}.d VERBATIM COMMENT "GLSL ${name}")
        add_custom_command(
            OUTPUT ${cpp}
            COMMAND ${CMAKE_COMMAND} -DSPIRV=${spirv} -DCPP=${cpp} -DSYMBOL=${symbol} -DNAME=${name}
                    -P ${MACULA_SHADERS_SCRIPT}
            DEPENDS ${spirv} ${MACULA_SHADERS_SCRIPT} VERBATIM COMMENT "")
        list(APPEND cpps ${cpp})
        string(APPEND declarations "extern const gpu::ShaderCode ${symbol};  // ${name}\n")
    endforeach()

    file(CONFIGURE OUTPUT ${generated}/shaders/${target}.h CONTENT "// Made by macula_shaders. Do not edit.
#pragma once

#include \"pipeline/gpu/shader_code.h\"

namespace macula::shaders {
@declarations@}  // namespace macula::shaders
" @ONLY)
    add_library(macula_shaders_${target} STATIC ${cpps})
    add_library(macula::shaders_${target} ALIAS macula_shaders_${target})
    set_target_properties(macula_shaders_${target} PROPERTIES EXPORT_NAME shaders_${target} CXX_VISIBILITY_PRESET hidden
        UNITY_BUILD OFF)  # arrays, all of one name
    # shaders/ itself is included for the structs in shaders/shared.
    target_include_directories(macula_shaders_${target} PUBLIC
        $<BUILD_INTERFACE:${generated}> $<BUILD_INTERFACE:${root}> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
endfunction()
