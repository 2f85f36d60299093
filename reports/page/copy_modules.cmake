# Copies the pages' own modules beside the installed packages: cmake -DFROM=... -DTO=... -P copy_modules.cmake
set(rooms charts dashboard data sections styles)
list(TRANSFORM rooms PREPEND "${TO}/" OUTPUT_VARIABLE old)
file(REMOVE_RECURSE ${old})
list(TRANSFORM rooms PREPEND "${FROM}/")
file(GLOB modules "${FROM}/*.js" "${FROM}/build.mjs" "${FROM}/template.html")
file(COPY ${modules} ${rooms} DESTINATION "${TO}")
